// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/measures.hpp"
#include "sample/failure.hpp"
#include "sample/glued_layers.hpp"
#include "sample/health.hpp"

namespace flowslide {
namespace {

/// Gap up to which a grain belongs to the layer at a plane, as a share of the mean diameter.
constexpr double layer_reach = 0.25;
/// Of the stresses at the ends of stages 2 and 3, which only lead on.
constexpr double intermediate_tolerance = 1e-2;
/// Steps between two looks at the whole assembly.
constexpr std::int64_t inspection_interval = 1500;

class Preparation {
 public:
  Preparation(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe)
      : engine_(engine), recipe_(recipe), observe_(observe) {}

  PreparedSample run() {
    Assembly assembly = lattice_packing(recipe_.packing);
    grains_ = assembly.size();
    solid_volume_ = assembly.solid_volume();
    if (recipe_.periodic_height) assembly.cell.periodic = {true, true, true};
    EngineSettings settings{recipe_.material, recipe_.time_step, recipe_.drag};
    settings.material.sliding_friction = recipe_.preparation_friction;
    engine_.load(assembly, settings);

    stage_ = 1;
    compact();
    stage_ = 2;
    reach({0.1 * recipe_.normal_stress, std::nullopt, recipe_.servo_rates[0]}, intermediate_tolerance);
    stage_ = 3;
    assembly = engine_.save();
    assembly.cell.periodic = {true, true, recipe_.periodic_height};
    engine_.load(assembly, settings);
    reach({0.2 * recipe_.normal_stress, std::nullopt, recipe_.servo_rates[1]}, intermediate_tolerance);
    stage_ = 4;
    assembly = engine_.save();
    if (!recipe_.periodic_height) glue_layers(assembly, layer_reach * assembly.mean_diameter());
    settings.material = recipe_.material;
    engine_.load(assembly, settings);
    reach({recipe_.normal_stress, recipe_.shear_stress, recipe_.servo_rates[2]}, recipe_.stress_tolerance);
    stage_ = 5;
    settings.drag = 0.0;
    engine_.set(settings);
    return rest();
  }

 private:
  double present_void_ratio() const { return engine_.cell().volume() / solid_volume_ - 1.0; }

  void advance(std::int64_t steps) {
    engine_.run(steps);
    steps_ += steps;
    stress_ = engine_.cell_stress();
    check_exchange(engine_, stress_, grains_);
    if (observe_) observe_({stage_, steps_, present_void_ratio(), stress_});
  }

  void compact() {
    const std::int64_t last = steps_ + recipe_.most_steps;
    const double rate = recipe_.compaction_rate;
    while (present_void_ratio() > recipe_.loose_void_ratio) {
      // The velocity of the walls is constant: that of the first moment.
      const Cell cell = engine_.cell();
      BoundaryMotion motion;
      motion.compression_rate_x = motion.compression_rate_y = rate;
      motion.bottom_velocity.z() = 0.5 * rate * cell.height();
      motion.top_velocity.z() = -0.5 * rate * cell.height();
      engine_.move(motion);
      advance(recipe_.servo_interval);
      if (steps_ > last) fail("the void ratio did not fall to its target");
    }
    engine_.move({});
  }

  /// Runs the servo until the stresses stay at their targets and the grains have come to rest.
  void reach(const ServoTarget& target, double tolerance) {
    const std::int64_t last = steps_ + recipe_.most_steps;
    std::int64_t within = 0, next_inspection = steps_ + 2 * time_step_interval;
    while (true) {
      engine_.move(servo_motion(target, engine_.cell(), stress_));
      advance(recipe_.servo_interval);
      within = servo_deviation(target, stress_) < tolerance ? within + recipe_.servo_interval : 0;
      if (steps_ >= next_inspection) {  // a step that is too long keeps the servo from its target for ever
        check_contact_time_step(engine_.save(), recipe_.material, recipe_.time_step);
        next_inspection = steps_ + 2 * time_step_interval;
      }
      if (within >= inspection_interval) {
        within = 0;
        const Assembly assembly = engine_.save();
        check_assembly(assembly);
        if (kinetic_number(assembly, recipe_.material, target.normal) < recipe_.kinetic_tolerance) break;
      }
      if (steps_ > last)
        fail(fmt::format("the stresses are within {:.3g} of sigma_0, the tolerance is {}",
                         servo_deviation(target, stress_), tolerance));
    }
    engine_.move({});
  }

  /// Stands still without drag and tells whether the sample holds its stress.
  PreparedSample rest() {
    const ServoTarget target{recipe_.normal_stress, recipe_.shear_stress, 0.0};
    engine_.move({});
    for (int look = 0; look < 4; ++look) advance(inspection_interval / 2);
    PreparedSample sample;
    sample.assembly = engine_.save();
    check_assembly(sample.assembly);
    check_contact_time_step(sample.assembly, recipe_.material, recipe_.time_step);
    sample.stress = stress_;
    sample.void_ratio = void_ratio(sample.assembly);
    const double margin = sample.assembly.mean_diameter();
    sample.bulk_void_ratio =
        recipe_.periodic_height ? sample.void_ratio : void_ratio_of_bulk(sample.assembly, margin);
    sample.kinetic_number = kinetic_number(sample.assembly, recipe_.material, recipe_.normal_stress);
    sample.steps = steps_;
    constexpr double drift_factor = 4.0;
    const double deviation = servo_deviation(target, stress_);
    if (deviation > drift_factor * recipe_.stress_tolerance)
      fail(fmt::format("at rest the stress drifted to {:.3g} of sigma_0 from its target", deviation));
    return sample;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw NumericalFailure(
        fmt::format("sample preparation, stage {}, after {} steps: {} (e = {:.4f}, sigma = {:.5g} Pa, tau = {:.5g} Pa, "
                    "lateral {:.5g} "
                    "and {:.5g} Pa); lower the servo rates, or the tolerance, or try another seed",
                    stage_, steps_, what, present_void_ratio(), stress_.normal, stress_.shear, stress_.lateral_x,
                    stress_.lateral_y));
  }

  Engine& engine_;
  const SampleRecipe& recipe_;
  const PreparationObserver& observe_;
  std::uint64_t grains_ = 0;
  double solid_volume_ = 0.0;
  int stage_ = 0;
  std::int64_t steps_ = 0;
  CellStress stress_;
};

}  // namespace

PreparedSample prepare_sample(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe) {
  validate(recipe);
  return Preparation(engine, recipe, observe).run();
}

}  // namespace flowslide
