// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/mixing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "grains/measures.hpp"
#include "sample/health.hpp"
#include "sample/stable_time_step.hpp"

namespace flowslide {
namespace {

/// Approach velocity of the fastest grains, in mixing velocities: three standard deviations for each of the two.
constexpr double fastest_approach = 6.0;
/// Number of standard deviations by which the order of a mixed packing may exceed the mean of random packings.
constexpr double allowed_deviations = 2.0;

/// Order divided by its limit.
double excess(const MiddleOrder& order) {
  return order.value / order_of_random_positions(order.grains, allowed_deviations);
}

}  // namespace

bool LatticeMemory::forgotten() const {
  return std::all_of(order.begin(), order.end(), [](const MiddleOrder& along) { return excess(along) <= 1.0; });
}

std::string LatticeMemory::text() const {
  const auto most = std::max_element(order.begin(), order.end(),
                                     [](const MiddleOrder& a, const MiddleOrder& b) { return excess(a) < excess(b); });
  return fmt::format("{:.3g} along {}, where {:.3g} is allowed", most->value, "xyz"[most - order.begin()],
                     order_of_random_positions(most->grains, allowed_deviations));
}

LatticeMemory lattice_memory(const Assembly& assembly, const LatticePacking& packing) {
  LatticeMemory memory;
  for (int axis = 0; axis < 3; ++axis) memory.order[axis] = middle_order(assembly, axis, packing.counts[axis]);
  return memory;
}

std::int64_t steps_between_checks(const SampleRecipe& recipe) {
  const double way = recipe.packing.spacing * recipe.packing.largest_diameter;
  const double steps = way / (recipe.mixing_velocity * recipe.time_step);
  return static_cast<std::int64_t>(std::clamp(steps, 1.0, static_cast<double>(recipe.most_steps)));
}

void validate_impacts(const SampleRecipe& recipe) {
  if (recipe.mixing_velocity == 0.0) return;
  const double radius = 0.5 * recipe.packing.smallest_diameter;
  const double speed = fastest_approach * recipe.mixing_velocity;
  const double overlap = hertz_impact_overlap(radius, recipe.material, speed);
  if (overlap > 2.0 * radius * largest_overlap)
    throw std::invalid_argument(fmt::format(
        "mixing = {} m/s makes grains overlap by up to {:.3g} of their diameter, more than the {} that spheres may; "
        "choose a slower mixing, or stiffer grains",
        recipe.mixing_velocity, 0.5 * overlap / radius, largest_overlap));
  const double stable = time_step_for_impacts(radius, recipe.material, speed, recipe.time_step);
  if (recipe.time_step >= stable)
    throw std::invalid_argument(
        fmt::format("the time step {} s is too long for the impacts of mixing = {} m/s: choose one of at most {:.2g} "
                    "s, or a slower mixing",
                    recipe.time_step, recipe.mixing_velocity, 0.95 * stable));
}

}  // namespace flowslide
