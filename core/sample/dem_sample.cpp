// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/dem_sample.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <utility>

#include "grains/bulk_mean_stress.hpp"
#include "sample/health.hpp"

namespace flowslide {
namespace {

constexpr std::array stress_parts{std::pair{"normal_stress", &CellStress::normal},
                                  std::pair{"shear_stress", &CellStress::shear},
                                  std::pair{"transverse_stress", &CellStress::transverse},
                                  std::pair{"lateral_stress_x", &CellStress::lateral_x},
                                  std::pair{"lateral_stress_y", &CellStress::lateral_y}};

/// Tolerance for the stress of a prepared sample, relative to its normal stress. Another number of ranks sums in
/// another order, with other rounding.
constexpr double rounding_of_sums = 1e-9;

void add(std::map<std::string, double>& numbers, const std::string& prefix, const CellStress& stress) {
  for (const auto& [name, part] : stress_parts) numbers[prefix + name] = stress.*part;
}

CellStress stress_in(const SampleState& state, const std::string& prefix) {
  CellStress stress;
  for (const auto& [name, part] : stress_parts) stress.*part = state.number(prefix + name);
  return stress;
}

}  // namespace

DemSample::DemSample(std::unique_ptr<Engine> engine, const Assembly& assembly, const EngineSettings& settings)
    : DemSample(*engine, assembly, settings) {
  owned_ = std::move(engine);
}

DemSample::DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings)
    : engine_(engine),
      grains_(assembly.size()),
      solid_volume_(assembly.solid_volume()),
      smallest_radius_(assembly.smallest_radius()) {
  for (const Role layer : {Role::bottom_layer, Role::top_layer})
    if (const bool glued = std::find(assembly.role.begin(), assembly.role.end(), layer) != assembly.role.end();
        glued == assembly.cell.periodic[2])
      throw std::invalid_argument(glued ? "the sample has a glued layer in a cell that is periodic along z, which is "
                                          "sheared across its faces; make z rigid, or all grains mobile"
                                        : "the sample has no glued layers, which shear it; prepare it with "
                                          "prepare_sample");
  validate_time_step(settings.time_step, smallest_radius_, settings.material);
  validate_fields(settings);
  engine_.load(assembly, settings);
  stress_ = prepared_ = engine_.cell_stress();
  inspect_time_step();
}

void DemSample::inspect_time_step() {
  since_inspection_ = 0;
  check_contact_time_step(engine_.save(), settings().material, settings().time_step);
}

void DemSample::start_linear_velocity_field(double shear_rate) {
  Assembly assembly = engine_.save();
  Cell& cell = assembly.cell;
  const double at_rest = cell.periodic[2] ? 0.5 * (cell.lower.z() + cell.upper.z()) : cell.lower.z();
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile) {
      assembly.velocity[i].x() += shear_rate * (assembly.position[i].z() - at_rest);
      assembly.spin[i].y() += 0.5 * shear_rate;
    }
  if (cell.periodic[2]) cell.shear_velocity += shear_rate * cell.height();
  engine_.load(assembly, engine_.settings());
}

CellStress DemSample::strain(const LocalRun& run) {
  const std::clock_t start = std::clock();
  set_time_step(run.time_step);
  if (steps_ == 0 && linear_at_first_strain_) start_linear_velocity_field(run.rate.shear);
  const double height = engine_.cell().height();
  BoundaryMotion motion;
  motion.top_velocity = {run.rate.shear * height, 0.0, -run.rate.compression * height};
  engine_.move(motion);
  engine_.run(run.steps);
  if (run.measured) {
    stress_ = engine_.cell_stress();
    check_exchange(engine_, stress_, grains_);
  }
  shear_strain_ += run.rate.shear * run.duration();
  time_ += run.duration();
  steps_ += run.steps;
  since_inspection_ += run.steps;
  if (since_inspection_ >= time_step_interval) inspect_time_step();
  clock_ticks_ += std::clock() - start;
  return stress_;
}

void DemSample::set_time_step(double time_step) {
  EngineSettings settings = engine_.settings();
  if (time_step == settings.time_step) return;
  validate_time_step(time_step, smallest_radius_, settings.material);
  settings.time_step = time_step;
  engine_.set(settings);
}

double DemSample::mean_stress() const {
  const Assembly grains = assembly();
  const Material& material = settings().material;
  return bulk_mean_stress(grains, evaluate_contact_forces(grains, material, settings().time_step), material);
}

double DemSample::void_ratio() const { return engine_.cell().volume() / solid_volume_ - 1.0; }

SampleState DemSample::state() const {
  SampleState state;
  state.grains = engine_.save();
  state.numbers = {{"shear_strain", shear_strain_},
                   {"time", time_},
                   {"steps", static_cast<double>(steps_)},
                   {"time_step", engine_.settings().time_step},
                   {"processor_seconds", processor_seconds()}};
  add(state.numbers, "", stress_);
  add(state.numbers, "prepared_", prepared_);
  return state;
}

void DemSample::restore(const SampleState& state) {
  const CellStress prepared = stress_in(state, "prepared_");
  bool same = state.grains && state.grains->size() == grains_;
  for (const auto& [name, part] : stress_parts)
    same = same && std::abs(prepared.*part - prepared_.*part) <= rounding_of_sums * std::abs(prepared_.normal);
  if (!same)
    throw std::invalid_argument(
        "the state is that of another sample: its number of grains or its prepared stress is not that of this sample; "
        "restore the state into a sample of the same prepared assembly");
  EngineSettings settings = engine_.settings();
  settings.time_step = state.number("time_step");
  validate_time_step(settings.time_step, smallest_radius_, settings.material);
  const double shear_strain = state.number("shear_strain"), time = state.number("time");
  const double processor_seconds = state.number("processor_seconds");
  const std::int64_t steps = state.count("steps");
  const CellStress stress = stress_in(state, "");
  engine_.load(*state.grains, settings);
  shear_strain_ = shear_strain;
  time_ = time;
  steps_ = steps;
  constexpr double a_century = 3.2e9;  // s; no run takes longer
  clock_ticks_ = static_cast<std::clock_t>(std::clamp(processor_seconds, 0.0, a_century) * CLOCKS_PER_SEC);
  stress_ = stress;  // before its first step an engine may round the stress differently
}

Assembly DemSample::assembly() const {
  Assembly assembly = engine_.save();
  check_assembly(assembly);
  return assembly;
}

}  // namespace flowslide
