// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "grains/choice.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// One preparation of a search.
struct Trial {
  SampleRecipe recipe;
  double void_ratio = 0.0;
};

/// Where the void ratio of a sample is measured. The paper does not say.
enum class VoidRatioRegion {
  cell,  ///< the whole cell
  probe  ///< see probe_void_ratio
};

template <>
struct ChoiceNames<VoidRatioRegion> {
  static constexpr const char* what = "the region of the void ratio";
  static constexpr std::array names{"cell", "probe"};
};

/// Target of a search.
struct VoidRatioTarget {
  double void_ratio = 0.79;   ///< e_0 of the region
  double tolerance = 2e-3;    ///< largest deviation of e_0 from the target, > 0
  int most_trials = 10;
  VoidRatioRegion region = VoidRatioRegion::cell;
};

/// Throws std::invalid_argument if no packing of spheres at rest has this void ratio, if the tolerance is not positive,
/// or if no trial is allowed.
void validate(const VoidRatioTarget& target);

/// Searches for a sample with the void ratio of `target` by varying its preparation friction mu_1 and its seed. Returns
/// all trials that gave a sample; the last one is within the tolerance. `prepare` makes a sample and returns its void
/// ratio in the region of the target.
///
/// At one recipe the seeds scatter e_0 by 0.004 to 0.012, which is as large as the differences between the paper's
/// samples. A root finder therefore fails. Instead, each trial uses a new seed and the mu_1 that the mean of all trials
/// so far suggests, with the measured slope de_0/dmu_1 = 0.15. The realizations scatter around the target until one is
/// within the tolerance. If a preparation fails, for example because the packing is too loose to bear its stress at
/// rest, it counts as a trial, and the next seed follows. Throws NumericalFailure if no trial fits; the message gives
/// the nearest.
std::vector<Trial> search_void_ratio(const SampleRecipe& start, const VoidRatioTarget& target,
                                     const std::function<double(const SampleRecipe&)>& prepare);

/// A hash of the sources of search_void_ratio. Equal hashes find equal samples.
std::string search_version();

}  // namespace flowslide
