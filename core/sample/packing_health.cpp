// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/packing_health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "grains/slab_stress.hpp"
#include "grains/void_ratio_profile.hpp"

namespace flowslide {
namespace {

constexpr double packing_deviations = 4.0;  ///< standard deviations
constexpr int fewest_slices = 3;            ///< needed for a spread and a seam
constexpr int first_wave_number = 8, last_wave_number = 30;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

void measure_slices(AxisHealth& health, const std::vector<double>& void_ratios) {
  health.slices = static_cast<int>(void_ratios.size());
  if (health.slices < fewest_slices) return;
  const double middle = mean(void_ratios);
  double squares = 0.0;
  for (const double e : void_ratios) {
    squares += (e - middle) * (e - middle);
    health.largest_deviation = std::max(health.largest_deviation, std::abs(e - middle));
  }
  health.spread = std::sqrt(squares / (health.slices - 1));
  const auto third = health.slices / 3;
  const std::vector<double> inner(void_ratios.begin() + third, void_ratios.end() - third);
  const double others = mean(void_ratios) * health.slices - mean(inner) * static_cast<double>(inner.size());
  health.seam = mean(inner) - others / (2.0 * third);
}

AxisHealth axis_health(const Assembly& sample, const SampleRecipe& recipe, int axis) {
  AxisHealth health;
  std::vector<double> void_ratios = void_ratio_profile(sample, axis, slices_of_a_diameter(sample, axis));
  if (!recipe.periodic_height) void_ratios = without_wall_layers(void_ratios);
  measure_slices(health, void_ratios);
  const double cross_section = sample.cell.volume() / sample.cell.lengths()[axis];
  health.counting = counting_deviation(cross_section, sample.mean_diameter());
  const int sites = recipe.packing.counts[axis];
  health.lattice_order = positional_order(sample, axis, sites);
  health.middle_order = middle_order(sample, axis, sites);
  for (int waves = first_wave_number; waves <= last_wave_number; ++waves)
    health.largest_order = std::max(health.largest_order, positional_order(sample, axis, waves));
  return health;
}

/// A measured value of a sample, and its limit for a random packing.
struct Check {
  std::string what;
  double value, allowed;
};

std::vector<Check> checks(const AxisHealth& health, char axis) {
  std::vector<Check> all;
  if (health.middle_order.grains > 0)
    all.push_back({fmt::format("there is an order of the lattice along {}: in the middle of the cell it is", axis),
                   health.middle_order.value,
                   order_of_random_positions(health.middle_order.grains, packing_deviations)});
  if (health.slices < fewest_slices) return all;
  const double third = health.slices / 3, inner = health.slices - 2.0 * third;
  const double of_spread = 1.0 / std::sqrt(2.0 * (health.slices - 1));
  const double of_seam = std::sqrt(1.0 / inner + 0.5 / third);
  all.push_back({fmt::format("void ratios of slices across {} spread by", axis), health.spread,
                 health.counting * (1.0 + packing_deviations * of_spread)});
  all.push_back({fmt::format("the void ratio of a slice across {} is off the mean by", axis), health.largest_deviation,
                 health.counting * packing_deviations});
  all.push_back({fmt::format("there is a seam across {}: void ratios of its middle and its outer part differ by", axis),
                 std::abs(health.seam), health.counting * packing_deviations * of_seam});
  return all;
}

}  // namespace

PackingHealth packing_health(const Assembly& sample, const SampleRecipe& recipe) {
  PackingHealth health;
  for (int axis = 0; axis < 3; ++axis) health.axes[axis] = axis_health(sample, recipe, axis);
  health.network = contact_network(sample);
  const ContactForces forces = evaluate_contact_forces(sample, recipe.material, recipe.time_step);
  const Cell& cell = sample.cell;
  const double margin = recipe.periodic_height ? 0.0 : std::min(sample.mean_diameter(), 0.25 * cell.height());
  const double middle = 0.5 * (cell.lower.z() + cell.upper.z());
  health.lower_half = slope_stress(slab_stress(sample, forces, cell.lower.z() + margin, middle));
  health.upper_half = slope_stress(slab_stress(sample, forces, middle, cell.upper.z() - margin));
  return health;
}

std::string unevenness(const PackingHealth& health) {
  const Check* worst = nullptr;
  std::vector<Check> all;
  for (int axis = 0; axis < 3; ++axis)
    for (Check& check : checks(health.axes[axis], "xyz"[axis])) all.push_back(std::move(check));
  for (const Check& check : all)
    if (check.value > check.allowed && (!worst || check.value * worst->allowed > worst->value * check.allowed))
      worst = &check;
  if (!worst) return "";
  return fmt::format(
      "the sample is not as even as a random packing of its size: {} {:.3g}, where {:.3g} is allowed; mix the packing "
      "(preparation.mixing), let the drag be relative to the uniform compression (preparation.drag_reference), or take "
      "uneven samples (preparation.allow_uneven)",
      worst->what, worst->value, worst->allowed);
}

}  // namespace flowslide
