// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/dem_sample.hpp"

#include <algorithm>
#include <ctime>
#include <stdexcept>

#include "grains/bulk_mean_stress.hpp"
#include "sample/health.hpp"

namespace flowslide {

DemSample::DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings)
    : engine_(engine),
      grains_(assembly.size()),
      solid_volume_(assembly.solid_volume()),
      smallest_radius_(assembly.smallest_radius()) {
  for (const Role layer : {Role::bottom_layer, Role::top_layer})
    if (std::find(assembly.role.begin(), assembly.role.end(), layer) == assembly.role.end())
      throw std::invalid_argument("the sample has no glued layer to shear it by; prepare it with prepare_sample");
  validate_time_step(settings.time_step, smallest_radius_, settings.material);
  engine_.load(assembly, settings);
  stress_ = engine_.cell_stress();
}

void DemSample::start_linear_velocity_field(double shear_rate) {
  Assembly assembly = engine_.save();
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile) {
      assembly.velocity[i].x() += shear_rate * (assembly.position[i].z() - assembly.cell.lower.z());
      assembly.spin[i].y() += 0.5 * shear_rate;
    }
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

Assembly DemSample::assembly() const {
  Assembly assembly = engine_.save();
  check_assembly(assembly);
  return assembly;
}

}  // namespace flowslide
