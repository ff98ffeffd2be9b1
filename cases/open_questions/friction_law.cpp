// SPDX-License-Identifier: GPL-2.0-or-later
#include "friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace flowslide {
namespace {

constexpr int searched = 400;  ///< number of values of I_0 in the search, evenly spaced in log I

/// The least-squares line mu = slow + (fast - slow) x over x = 1/(1 + I_0/I).
FrictionLaw best_with(const std::vector<SteadyState>& states, double turning) {
  double x_mean = 0.0, mean = 0.0, xx = 0.0, xy = 0.0;
  const auto x_of = [&](const SteadyState& state) { return 1.0 / (1.0 + turning / state.inertial_number); };
  const double share = 1.0 / static_cast<double>(states.size());
  for (const SteadyState& state : states) {
    x_mean += share * x_of(state);
    mean += share * state.friction;
  }
  for (const SteadyState& state : states) {
    xx += (x_of(state) - x_mean) * (x_of(state) - x_mean);
    xy += (x_of(state) - x_mean) * (state.friction - mean);
  }
  const double slope = xy / xx, slow = mean - slope * x_mean;
  return {slow, slow + slope, turning};
}

/// The smallest and the largest I.
std::pair<double, double> range_of(const std::vector<SteadyState>& states) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const SteadyState& state : states) {
    low = std::min(low, state.inertial_number);
    high = std::max(high, state.inertial_number);
  }
  return {low, high};
}

}  // namespace

FrictionLaw law_of_glass_beads() {
  constexpr double degree = std::numbers::pi / 180.0;
  return {std::tan(20.9 * degree), std::tan(32.76 * degree), 0.279};
}

double deviation(const std::vector<SteadyState>& states, const FrictionLaw& law) {
  double sum = 0.0;
  for (const SteadyState& state : states) sum += std::pow(state.friction - law.at(state.inertial_number), 2);
  return std::sqrt(sum / static_cast<double>(states.size()));
}

bool tell_a_law(const std::vector<SteadyState>& states) {
  const auto [low, high] = range_of(states);
  return states.size() >= 4 && low > 0.0 && high > low;
}

FrictionLaw fit_friction_law(const std::vector<SteadyState>& states) {
  if (!tell_a_law(states))
    throw std::invalid_argument(
        "mu(I) has three numbers: fewer than four steady states do not tell them, nor do states "
        "of one inertial number, or of none above 0");
  const auto [low, high] = range_of(states);
  FrictionLaw best = best_with(states, low);
  for (int k = 1; k <= searched; ++k) {
    const FrictionLaw law = best_with(states, low * std::pow(high / low, static_cast<double>(k) / searched));
    if (deviation(states, law) < deviation(states, best)) best = law;
  }
  return best;
}

}  // namespace flowslide
