// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/dem_sample.hpp"

#include <algorithm>
#include <stdexcept>

#include "sample/health.hpp"

namespace flowslide {

DemSample::DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings)
    : engine_(engine), grains_(assembly.size()), solid_volume_(assembly.solid_volume()) {
  for (const Role layer : {Role::bottom_layer, Role::top_layer})
    if (std::find(assembly.role.begin(), assembly.role.end(), layer) == assembly.role.end())
      throw std::invalid_argument("the sample has no glued layer to shear it by; prepare it with prepare_sample");
  validate_time_step(settings.time_step, assembly.smallest_radius(), settings.material);
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

CellStress DemSample::strain(const StrainRate& rate, std::int64_t steps) {
  const double height = engine_.cell().height();
  BoundaryMotion motion;
  motion.top_velocity = {rate.shear * height, 0.0, -rate.compression * height};
  engine_.move(motion);
  engine_.run(steps);
  stress_ = engine_.cell_stress();
  check_exchange(engine_, stress_, grains_);
  const double duration = static_cast<double>(steps) * engine_.settings().time_step;
  shear_strain_ += rate.shear * duration;
  time_ += duration;
  steps_ += steps;
  return stress_;
}

double DemSample::void_ratio() const { return engine_.cell().volume() / solid_volume_ - 1.0; }

Assembly DemSample::assembly() const {
  Assembly assembly = engine_.save();
  check_assembly(assembly);
  return assembly;
}

}  // namespace flowslide
