// SPDX-License-Identifier: GPL-2.0-or-later
// Experiments that several scenes make.
#pragma once
#include <functional>
#include <vector>

#include "sample/dem_sample.hpp"
#include "workshop.hpp"

namespace flowslide {

/// One look at a sample that is sheared.
struct Look {
  double strain = 0.0;
  CellStress stress;
};

/// Shears a prepared sample from the linear velocity field to `strain` and looks at it `looks` times, evenly.
std::vector<Look> shear(const Workshop& workshop, const Assembly& sample, const EngineSettings& settings, double rate,
                        double strain, int looks);

/// The loose sample of the suite made higher by a share: loose enough to flow.
Assembly expanded(const Workshop& workshop, double share);

/// Largest shear stress, Pa.
double peak_of(const std::vector<Look>& looks);
/// Means from a strain on, Pa.
double mean_shear(const std::vector<Look>& looks, double from);
double mean_normal(const std::vector<Look>& looks, double from);

/// The time step (s) that is `share` of the Rayleigh time of the smallest grain.
double time_step_of(double share, const Assembly& sample, const Material& material);

/// Follows a slide on a fresh DEM sample, `observe` told after each exchange.
SlideState slide_on_grains(const Workshop& workshop, const Assembly& sample, const SlideSettings& settings,
                           const StopConditions& stop, bool linear_start,
                           const std::function<void(const Slide&)>& observe = {});

/// Kinetic energy of the mobile grains, spins included, and energy of all springs, J.
double energy_of(const Assembly& assembly, const Material& material);

}  // namespace flowslide
