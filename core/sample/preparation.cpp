// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/preparation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dem/source_hashes.hpp"
#include "grains/agitation.hpp"
#include "grains/measures.hpp"
#include "sample/failure.hpp"
#include "sample/glued_layers.hpp"
#include "sample/health.hpp"
#include "sample/mixing.hpp"
#include "sample/servo.hpp"

namespace flowslide {
namespace {

/// Tolerance of the stresses at the end of stages 2 and 3, as a fraction of the normal stress. These stages only lead
/// to stage 4.
constexpr double intermediate_tolerance = 1e-2;
/// Steps for which the stresses must be within their tolerance before the grains are inspected.
constexpr std::int64_t inspection_interval = 1500;
constexpr const char* servo_remedy = "lower the servo rates, or the tolerance, or try another seed";

class Preparation {
 public:
  Preparation(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe)
      : engine_(engine), recipe_(recipe), observe_(observe) {}

  PreparedSample run(const PreparationState* from) {
    Assembly packing = lattice_packing(recipe_.packing);
    if (recipe_.periodic_height) packing.cell.periodic = {true, true, true};
    grains_ = packing.size();
    solid_volume_ = packing.solid_volume();
    if (from != nullptr) continue_from(*from);
    else
      begin_with(packing);
    while (stage_ < 5) {
      switch (stage_) {
        case 0: mix(); break;
        case 1: compact(); break;
        case 2: run_servo({0.1 * recipe_.normal_stress, {}, recipe_.servo_rates[0]}, intermediate_tolerance); break;
        case 3: run_servo({0.2 * recipe_.normal_stress, {}, recipe_.servo_rates[1]}, intermediate_tolerance); break;
        default:
          run_servo({recipe_.normal_stress, recipe_.shear_stress, recipe_.servo_rates[2]}, recipe_.stress_tolerance);
      }
      engine_.move({});
      begin(stage_ + 1);
    }
    return rest();
  }

 private:
  double present_void_ratio() const { return engine_.cell().volume() / solid_volume_ - 1.0; }

  /// Settings of the present stage.
  EngineSettings settings() const {
    const bool drags = stage_ >= 1 && stage_ <= 4 && recipe_.drag_stages[stage_ - 1];
    EngineSettings settings{recipe_.material, recipe_.time_step, drags ? recipe_.drag : 0.0, recipe_.drag_reference};
    if (stage_ < 4) settings.material.sliding_friction = recipe_.preparation_friction;
    if (stage_ >= 1 && stage_ < 4) settings.material.restitution = recipe_.preparation_restitution;
    return settings;
  }

  void begin_with(Assembly& packing) {
    stage_ = recipe_.mixing_velocity > 0.0 ? 0 : 1;
    if (stage_ == 0) {
      agitate(packing, recipe_.mixing_velocity, recipe_.packing.seed);
      next_inspection_ = steps_between_checks(recipe_);
    }
    engine_.load(packing, settings());
  }

  void begin(int stage) {
    stage_ = stage;
    stage_start_ = steps_;
    within_ = 0;
    next_inspection_ = steps_ + 2 * time_step_interval;
    if (stage == 3 || stage == 4) {
      Assembly assembly = engine_.save();
      if (stage == 3) assembly.cell.periodic = {true, true, recipe_.periodic_height};
      else if (!recipe_.periodic_height) glue_layers(assembly, recipe_.glue);
      engine_.load(assembly, settings());
    } else if (stage == 5 || settings().drag != engine_.settings().drag ||
               !(settings().material == engine_.settings().material)) {
      engine_.set(settings());
    }
  }

  PreparationState state() const {
    return {stage_, steps_, stage_start_, within_, next_inspection_, stress_, engine_.save()};
  }

  void continue_from(const PreparationState& from) {
    if (from.assembly.size() != grains_)
      throw std::invalid_argument(
          fmt::format("a preparation of {} grains cannot continue from a state of {}", grains_, from.assembly.size()));
    stage_ = from.stage;
    steps_ = from.steps;
    stage_start_ = from.stage_start;
    within_ = from.within;
    next_inspection_ = from.next_inspection;
    stress_ = from.stress;
    engine_.load(from.assembly, settings());
  }

  void advance(std::int64_t steps) {
    engine_.run(steps);
    steps_ += steps;
    stress_ = engine_.cell_stress();
    check_exchange(engine_, stress_, grains_);
  }

  void observe() const {
    if (observe_) observe_({stage_, steps_, present_void_ratio(), stress_, [this] { return state(); }});
  }

  /// Lets the grains fly about until the order of their lattice has vanished.
  void mix() {
    while (true) {
      advance(recipe_.servo_interval);
      if (steps_ >= next_inspection_) {
        const Assembly assembly = engine_.save();
        check_assembly(assembly);
        check_contact_time_step(assembly, recipe_.material, recipe_.time_step);
        next_inspection_ = steps_ + steps_between_checks(recipe_);
        const LatticeMemory memory = lattice_memory(assembly, recipe_.packing);
        if (memory.forgotten()) return;
        if (steps_ > recipe_.most_steps)
          fail(fmt::format("the order at the wave number of the lattice is {}", memory.text()),
               "choose a faster mixing, or allow more steps");
      }
      observe();
    }
  }

  void compact() {
    const double rate = recipe_.compaction_rate;
    while (present_void_ratio() > recipe_.loose_void_ratio) {
      // The velocities of the walls stay constant until the next `move`.
      const Cell cell = engine_.cell();
      BoundaryMotion motion;
      motion.compression_rate_x = motion.compression_rate_y = rate;
      motion.bottom_velocity.z() = 0.5 * rate * cell.height();
      motion.top_velocity.z() = -0.5 * rate * cell.height();
      engine_.move(motion);
      advance(recipe_.servo_interval);
      if (steps_ - stage_start_ > recipe_.most_steps)
        fail("the void ratio did not fall to its target", "choose a faster compaction, or allow more steps");
      observe();
    }
  }

  /// Runs the servo until the stresses stay at their targets and the grains have come to rest.
  void run_servo(const ServoTarget& target, double tolerance) {
    while (true) {
      engine_.move(servo_motion(target, engine_.cell(), stress_));
      advance(recipe_.servo_interval);
      within_ = servo_deviation(target, stress_) < tolerance ? within_ + recipe_.servo_interval : 0;
      if (steps_ >= next_inspection_) {  // with a time step that is too long the servo never reaches its target
        check_contact_time_step(engine_.save(), recipe_.material, recipe_.time_step);
        next_inspection_ = steps_ + 2 * time_step_interval;
      }
      if (within_ >= inspection_interval) {
        within_ = 0;
        const Assembly assembly = engine_.save();
        check_assembly(assembly);
        if (kinetic_number(assembly, recipe_.material, target.normal) < recipe_.kinetic_tolerance) return;
      }
      if (steps_ - stage_start_ > recipe_.most_steps)
        fail(fmt::format("the stresses are within {:.3g} of sigma_0, the tolerance is {}",
                         servo_deviation(target, stress_), tolerance),
             servo_remedy);
      observe();
    }
  }

  /// Stands still without drag and checks that the sample holds its stress.
  PreparedSample rest() {
    const ServoTarget target{recipe_.normal_stress, recipe_.shear_stress, 0.0};
    while (steps_ < stage_start_ + 2 * inspection_interval) {
      advance(inspection_interval / 2);
      observe();
    }
    PreparedSample sample;
    sample.assembly = engine_.save();
    check_assembly(sample.assembly);
    check_contact_time_step(sample.assembly, recipe_.material, recipe_.time_step);
    sample.stress = stress_;
    sample.void_ratio = void_ratio(sample.assembly);
    sample.probe_void_ratio = recipe_.periodic_height ? sample.void_ratio : probe_void_ratio(sample.assembly);
    sample.kinetic_number = kinetic_number(sample.assembly, recipe_.material, recipe_.normal_stress);
    sample.steps = steps_;
    constexpr double drift_factor = 4.0;
    const double deviation = servo_deviation(target, stress_);
    if (deviation > drift_factor * recipe_.stress_tolerance)
      fail(fmt::format("at rest the stress drifted to {:.3g} of sigma_0 from its target", deviation), servo_remedy);
    return sample;
  }

  [[noreturn]] void fail(const std::string& what, const char* remedy) const {
    throw NumericalFailure(fmt::format(
        "sample preparation, {}, after {} steps: {} (e = {:.4f}, sigma = {:.5g} Pa, tau = {:.5g} Pa, lateral "
        "{:.5g} and {:.5g} Pa); {}",
        name_of_stage(stage_), steps_, what, present_void_ratio(), stress_.normal, stress_.shear, stress_.lateral_x,
        stress_.lateral_y, remedy));
  }

  Engine& engine_;
  const SampleRecipe& recipe_;
  const PreparationObserver& observe_;
  std::uint64_t grains_ = 0;
  double solid_volume_ = 0.0;
  int stage_ = 1;  // from here on as in PreparationState
  std::int64_t steps_ = 0, stage_start_ = 0, within_ = 0, next_inspection_ = 0;
  CellStress stress_;
};

}  // namespace

std::string name_of_stage(int stage) {
  if (stage == 0) return "mixing";
  return stage <= 4 ? fmt::format("stage {} of 4", stage) : "rest";
}

PreparedSample prepare_sample(Engine& engine, const SampleRecipe& recipe, const PreparationObserver& observe,
                              const PreparationState* from) {
  validate(recipe);
  return Preparation(engine, recipe, observe).run(from);
}

std::string preparation_version() { return source_hashes::preparation; }

}  // namespace flowslide
