// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "dem/drag_reference.hpp"
#include "grains/material.hpp"
#include "grains/packing.hpp"

namespace flowslide {

/// Everything that determines a prepared sample. Stages 1 to 4 are those of the paper, sec. 2.2.1.
struct SampleRecipe {
  LatticePacking packing;
  Material material;                      ///< of the finished sample (Table 1)
  double normal_stress = 28.34e3;         ///< sigma_0, target of the three normal stresses, Pa
  double shear_stress = 2.650e3;          ///< tau_0, target of sigma_zx, Pa; 0 prepares an isotropic sample
  double preparation_friction = 0.3;      ///< mu_1 of stages 1 to 3; decides the density
  double preparation_restitution = 0.8;   ///< of stages 1 to 3; below the material's, packings come to rest looser
  bool periodic_height = false;           ///< all three axes are periodic from stage 1 on and no layer is glued: for
                                          ///< homogeneous shear across the faces
  double drag = 0.03;  ///< c of the force -c (v - u) on each grain, kg/s; off before the sample is used
  DragReference drag_reference = DragReference::rest;       ///< what u is
  std::array<bool, 4> drag_stages{true, true, true, true};  ///< whether drag acts in stages 1, 2, 3 and 4
  double mixing_velocity = 0.0;           ///< stage 0: the packing flies about until its lattice is forgotten. Standard
                                          ///< deviation of each component, m/s; 0: there is no such stage
  double time_step = 1e-5;                ///< dt_L of the preparation, s

  double loose_void_ratio = 1.2;          ///< end of stage 1
  double compaction_rate = 1.0;           ///< stage 1, of each axis, 1/s
  std::array<double, 3> servo_rates{0.2, 0.1, 0.05};  ///< largest rates in stages 2, 3 and 4, 1/s
  int servo_interval = 30;                ///< steps between two looks of the servo
  double stress_tolerance = 1e-3;         ///< of sigma_0, for each stress at the end of a stage
  double kinetic_tolerance = 1e-8;        ///< mean kinetic energy of a grain over p D^3 at rest
  std::int64_t most_steps = 2'000'000;    ///< per stage; a stage that needs more is a failure

  /// Text that is equal exactly when two recipes prepare the same sample by one procedure and engine. It leaves out
  /// `most_steps`: a sample that is complete needed no more of them.
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

/// Throws std::invalid_argument: what is wrong, the value, what is allowed, how to mend it.
void validate(const SampleRecipe& recipe);

}  // namespace flowslide
