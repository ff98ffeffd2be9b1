// SPDX-License-Identifier: GPL-2.0-or-later
#include "detectors.hpp"

#include <algorithm>
#include <cmath>

#include "grains/time_step_share.hpp"
#include "sample/failure.hpp"
#include "sample/health.hpp"

namespace flowslide {
namespace {

constexpr std::int64_t steps_at_rest = 3000;
constexpr double kinetic_alarm = 1e-7;     ///< ten times the tolerance of a preparation
constexpr double energy_tolerance = 0.05;  ///< fraction of the work, which is integrated over few readings

bool overlaps(const Assembly& assembly) {
  try {
    check_assembly(assembly);
    return false;
  } catch (const NumericalFailure&) {
    return true;
  }
}

bool moves_at_rest(Engine& engine, const Assembly& sample, const EngineSettings& settings) {
  engine.load(sample, settings);
  const double pressure = engine.cell_stress().mean();
  engine.run(steps_at_rest);
  return !(kinetic_number(engine.save(), settings.material, pressure) < kinetic_alarm);
}

Assembly with_linear_field(Assembly assembly, double rate) {
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    assembly.velocity[i].x() += rate * (assembly.position[i].z() - assembly.cell.lower.z());
    assembly.spin[i].y() += 0.5 * rate;
  }
  return assembly;
}

}  // namespace

UncheckedRun run_unchecked(Engine& engine, const Assembly& sample, const EngineSettings& settings,
                           const Shearing& shearing) {
  const auto [rate, strain, readings] = shearing;
  UncheckedRun run;
  run.rest_alarm = moves_at_rest(engine, sample, settings);
  const Assembly start = with_linear_field(sample, rate);
  engine.load(start, settings);
  BoundaryMotion motion;
  motion.top_velocity.x() = rate * start.cell.height();
  engine.move(motion);
  const auto steps = static_cast<std::int64_t>(std::llround(strain / (rate * settings.time_step * readings)));
  const double volume = start.cell.volume(), first_energy = energy_of(start, settings.material);
  run.largest_share = time_step_share(sample, settings.material, settings.time_step);
  double work = 0.0, before = engine.cell_stress().shear;
  for (int reading = 0; reading < readings && !run.lost; ++reading) {
    engine.run(steps);
    const double now = engine.cell_stress().shear;
    const Assembly assembly = engine.save();
    run.lost = !std::isfinite(now) || engine.count_grains() != sample.size();
    if (run.lost) break;
    work += volume * 0.5 * (before + now) * rate * settings.time_step * static_cast<double>(steps);
    before = now;
    run.peak = std::max(run.peak, now);
    run.largest_share = std::max(run.largest_share, time_step_share(assembly, settings.material, settings.time_step));
    run.overlap_alarm = run.overlap_alarm || overlaps(assembly);
    const double gain = energy_of(assembly, settings.material) - first_energy;
    run.energy_alarm = run.energy_alarm || gain > work + energy_tolerance * std::abs(work);
  }
  run.stiffness_alarm = run.largest_share >= 1.0;
  return run;
}

}  // namespace flowslide
