// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "dem/drag_reference.hpp"
#include "grains/material.hpp"
#include "grains/packing.hpp"
#include "sample/glued_layers.hpp"

namespace flowslide {

/// Everything that determines a prepared sample besides engine and procedure. Stages as in prepare_sample.
struct SampleRecipe {
  LatticePacking packing;
  Material material;                      ///< of the finished sample (Table 1)
  double normal_stress = 28.34e3;         ///< sigma_0, target of the three normal stresses, Pa
  double shear_stress = 2.650e3;          ///< tau_0, target of the shear stress, Pa; 0 prepares an isotropic sample
  double preparation_friction = 0.3;      ///< mu_1 of stages 0 to 3; controls the density
  double preparation_restitution = 0.8;   ///< of stages 1 to 3; a value below the material's gives looser packings
  bool periodic_height = false;           ///< all three axes are periodic from the start and no layer is glued, for
                                          ///< homogeneous shear across the faces
  Glue glue = Glue::one_layer;            ///< the grains that are glued in stage 4
  double drag = 0.03;  ///< c of the force -c (v - u) on each grain, kg/s; 0 in the finished sample
  DragReference drag_reference = DragReference::rest;       ///< the velocity u
  std::array<bool, 4> drag_stages{true, true, true, true};  ///< whether drag acts in stages 1, 2, 3 and 4
  double mixing_velocity = 0.0;           ///< standard deviation of each velocity component at the start of stage 0,
                                          ///< m/s; 0: no stage 0
  double time_step = 1e-5;                ///< dt_L of the preparation, s

  double loose_void_ratio = 1.2;          ///< void ratio at the end of stage 1
  double compaction_rate = 1.0;           ///< compression rate of each axis in stage 1, 1/s
  std::array<double, 3> servo_rates{0.2, 0.1, 0.05};  ///< largest strain rates in stages 2, 3 and 4, 1/s
  int servo_interval = 30;                ///< steps between two updates of the servo
  double stress_tolerance = 1e-3;         ///< of each stress at the end of stage 4, as a fraction of sigma_0
  double kinetic_tolerance = 1e-8;        ///< largest kinetic_number at the end of stages 2 to 4
  std::int64_t most_steps = 2'000'000;    ///< limit per stage; a stage that needs more fails

  /// Two recipes have equal texts exactly if they prepare the same sample with one procedure and engine. The text
  /// leaves out `most_steps`, which does not affect a completed sample.
  std::string text() const;

  static constexpr auto fields() {
    return std::tuple{
        Field{"packing", &SampleRecipe::packing},
        Field{"material", &SampleRecipe::material},
        Field{"normal_stress", &SampleRecipe::normal_stress, "Pa", Bounds::positive()},
        Field{"shear_stress", &SampleRecipe::shear_stress, "Pa"},
        Field{"preparation_friction", &SampleRecipe::preparation_friction, "1", Bounds::between(0.0, 2.0)},
        Field{"restitution", &SampleRecipe::preparation_restitution, "1", Bounds::above_up_to(0.0, 1.0)},
        Field{"periodic_height", &SampleRecipe::periodic_height},
        Field{"glue", &SampleRecipe::glue},
        Field{"drag", &SampleRecipe::drag, "kg/s", Bounds::not_negative()},
        Field{"drag_reference", &SampleRecipe::drag_reference},
        Field{"drag_stages", &SampleRecipe::drag_stages},
        Field{"mixing", &SampleRecipe::mixing_velocity, "m/s", Bounds::not_negative()},
        Field{"time_step", &SampleRecipe::time_step, "s", Bounds::positive()},
        Field{"loose_void_ratio", &SampleRecipe::loose_void_ratio, "1", Bounds::inside(0.95, 4.0)},
        Field{"compaction_rate", &SampleRecipe::compaction_rate, "1/s", Bounds::positive()},
        Field{"servo_rates", &SampleRecipe::servo_rates, "1/s", Bounds::positive()},
        Field{"servo_interval", &SampleRecipe::servo_interval, "1", Bounds::between(1, 10000)},
        Field{"stress_tolerance", &SampleRecipe::stress_tolerance, "1", Bounds::inside(0.0, 0.1)},
        Field{"kinetic_tolerance", &SampleRecipe::kinetic_tolerance, "1", Bounds::positive()},
        Field{"most_steps", &SampleRecipe::most_steps, "1", Bounds::at_least(1), Effect::limit_only}};
  }
};
static_assert(lists_every_member<SampleRecipe>());

/// Throws std::invalid_argument if a value is out of its range, if no packing can bear the shear stress, or if the time
/// step is too long (see validate_time_step and validate_impacts).
void validate(const SampleRecipe& recipe);

}  // namespace flowslide
