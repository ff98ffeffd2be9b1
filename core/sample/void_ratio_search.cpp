// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/void_ratio_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dem/source_hashes.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

constexpr double slope = 0.15;  ///< measured de_0/dmu_1 between mu_1 = 0.25 and 0.5
/// Bounds of mu_1; a search that starts above the upper bound keeps its start as the bound. Above the bound, the
/// friction of stage 4 (0.5) collapses most of the gain in void ratio.
constexpr double smallest_friction = 0.0, largest_friction = 0.6;
constexpr double densest = 0.55, loosest = 1.0;  ///< e_0 of random packings of spheres: 0.56 to about 0.9

}  // namespace

void validate(const VoidRatioTarget& target) {
  if (!(target.void_ratio > densest && target.void_ratio < loosest))
    throw std::invalid_argument(
        fmt::format("the void ratio {} cannot be reached: packings of spheres at rest lie between "
                    "{} and {}",
                    target.void_ratio, densest, loosest));
  if (!(target.tolerance > 0.0))
    throw std::invalid_argument(fmt::format("the tolerance {} of the void ratio must be > 0", target.tolerance));
  if (target.most_trials < 1)
    throw std::invalid_argument(
        fmt::format("{} trials cannot find a void ratio; allow at least 1", target.most_trials));
}

std::vector<Trial> search_void_ratio(const SampleRecipe& start, const VoidRatioTarget& target,
                                     const std::function<double(const SampleRecipe&)>& prepare) {
  validate(target);
  std::vector<Trial> trials;
  SampleRecipe recipe = start;
  double offset_sum = 0.0;
  const auto error = [&](const Trial& trial) { return std::abs(trial.void_ratio - target.void_ratio); };
  std::string last_failure;
  for (int attempt = 0; attempt < target.most_trials; ++attempt) {
    try {
      trials.push_back({recipe, prepare(recipe)});
    } catch (const NumericalFailure& failure) {
      last_failure = failure.what();
      recipe.packing.seed += 1;
      continue;
    }
    if (error(trials.back()) <= target.tolerance) return trials;
    offset_sum += trials.back().void_ratio - slope * recipe.preparation_friction;
    const double offset = offset_sum / static_cast<double>(trials.size());
    recipe.preparation_friction = std::clamp((target.void_ratio - offset) / slope, smallest_friction,
                                             std::max(largest_friction, start.preparation_friction));
    recipe.packing.seed += 1;
  }
  if (trials.empty()) throw NumericalFailure(last_failure);
  const Trial& nearest = *std::min_element(trials.begin(), trials.end(),
                                           [&](const Trial& a, const Trial& b) { return error(a) < error(b); });
  throw NumericalFailure(fmt::format(
      "no sample with the void ratio {} +- {} in {} trials; the nearest has {:.4f}, at the preparation friction {:.3f} "
      "and the drag {} kg/s. {}, or allow a wider tolerance or more trials",
      target.void_ratio, target.tolerance, target.most_trials, nearest.void_ratio, nearest.recipe.preparation_friction,
      nearest.recipe.drag,
      nearest.void_ratio < target.void_ratio ? "A larger drag opens looser samples"
                                             : "A smaller drag opens denser samples"));
}

std::string search_version() { return source_hashes::search; }

}  // namespace flowslide
