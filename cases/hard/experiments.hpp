// SPDX-License-Identifier: GPL-2.0-or-later
// Experiments that several scenes use.
#pragma once
#include <functional>
#include <vector>

#include "sample/dem_sample.hpp"
#include "workshop.hpp"

namespace flowslide {

/// The state of a sample at one moment of a shear test.
struct Look {
  double strain = 0.0;
  CellStress stress;
};

/// Shears a prepared sample from a linear velocity field to `strain`. Returns its state at `looks` equal intervals of
/// strain. `rate`: 1/s. Throws NumericalFailure.
std::vector<Look> shear(const Workshop& workshop, const Assembly& sample, const EngineSettings& settings, double rate,
                        double strain, int looks);

/// The loose sample of the suite, extended in height by the fraction `share`, which makes it loose enough to flow.
Assembly expanded(const Workshop& workshop, double share);

/// Largest shear stress, Pa.
double peak_of(const std::vector<Look>& looks);
/// Means over the looks at a strain of at least `from`, Pa.
double mean_shear(const std::vector<Look>& looks, double from);
double mean_normal(const std::vector<Look>& looks, double from);

/// Time step, s: the fraction `share` of the Rayleigh time of the smallest grain.
double time_step_of(double share, const Assembly& sample, const Material& material);

/// Runs a slide on a new DEM sample until it stops. Calls `observe` after each exchange. Returns the last state.
SlideState slide_on_grains(const Workshop& workshop, const Assembly& sample, const SlideSettings& settings,
                           const StopConditions& stop, bool linear_start,
                           const std::function<void(const Slide&)>& observe = {});

/// Kinetic energy of the mobile grains, with their spin, plus the energy of all springs, J.
double energy_of(const Assembly& assembly, const Material& material);

}  // namespace flowslide
