// SPDX-License-Identifier: GPL-2.0-or-later
// Experiments that several scenes use.
#pragma once
#include <functional>
#include <vector>

#include "sample/dem_sample.hpp"
#include "scene_context.hpp"

namespace flowslide {

/// Simple shear at a constant rate.
struct Shearing {
  double rate = 0.0;  ///< 1/s
  double final_strain = 0.0;
  int readings = 1;  ///< number of readings, at equal intervals of strain; the last one at the final strain
};

/// The state of a sample at one moment of a shear test.
struct ShearReading {
  double strain = 0.0;
  CellStress stress;
};

/// Shears a prepared sample from a linear velocity field. Throws NumericalFailure.
std::vector<ShearReading> shear(const SceneContext& context, const Assembly& sample, const EngineSettings& settings,
                                const Shearing& shearing);

/// The loose sample of the settings, extended in height by the fraction `share`, which makes it loose enough to flow.
Assembly expanded(const SceneContext& context, double share);

/// Largest shear stress, Pa.
double peak_of(const std::vector<ShearReading>& readings);
/// Means over the readings at a strain of at least `from`, Pa.
double mean_shear(const std::vector<ShearReading>& readings, double from);
double mean_normal(const std::vector<ShearReading>& readings, double from);

/// Time step, s: the fraction `share` of the Rayleigh time of the smallest grain.
double time_step_of(double share, const Assembly& sample, const Material& material);

/// A slide on a DEM sample, from its start to its stop.
struct GrainSlide {
  SlideSettings settings;
  StopConditions stop;
  bool linear_start = false;                       ///< see DemSample::start_linear_at_first_strain
  std::function<void(const Slide&)> observe = {};  ///< called after each exchange
};

/// Runs a slide on a new DEM sample until it stops. Returns the last state.
SlideState run_slide(const SceneContext& context, const Assembly& sample, const GrainSlide& planned);

/// Kinetic energy of the mobile grains, with their spin, plus the energy of all springs, J.
double energy_of(const Assembly& assembly, const Material& material);

}  // namespace flowslide
