// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "sample/recipe.hpp"

namespace flowslide {

/// One preparation on the way to a void ratio.
struct Trial {
  SampleRecipe recipe;
  double void_ratio = 0.0;
};

/// What a search looks for.
struct VoidRatioTarget {
  double void_ratio = 0.79;   ///< e_0 of the whole cell
  double tolerance = 2e-3;    ///< on either side
  int most_trials = 10;
};

/// Throws std::invalid_argument if no packing of spheres at rest has this void ratio, or the tolerance is not positive.
void validate(const VoidRatioTarget& target);

/// Searches the recipe for a void ratio by its preparation friction mu_1 and its seed, and returns all trials, the last
/// of them within the tolerance. `prepare` makes a sample and returns its void ratio.
///
/// Seeds scatter e_0 by 0.004 to 0.012 at one recipe, as much as the paper's spacing of samples, so a root finder has
/// nothing to hold on to. Each trial is a new seed at the mu_1 that the mean of all trials so far suggests, with the
/// measured slope de_0/dmu_1 = 0.15: the draws gather around the target until one falls within the tolerance.
/// A packing that fails, such as one too loose to bear its stress at rest, is a trial as well; the next seed follows.
/// Throws NumericalFailure if none fits; the message names the nearest one.
std::vector<Trial> search_void_ratio(const SampleRecipe& start, const VoidRatioTarget& target,
                                     const std::function<double(const SampleRecipe&)>& prepare);

/// A hash of the sources of search_void_ratio: equal versions find equal samples.
std::string search_version();

}  // namespace flowslide
