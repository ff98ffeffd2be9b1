// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/sample_health.hpp"

#include <fmt/format.h>

namespace flowslide {
namespace {

void add_axis(std::vector<Metric>& metrics, const AxisHealth& health, char axis) {
  const auto add = [&](const char* name, double value, const char* text) {
    metrics.push_back({fmt::format("{}_{}", name, axis), value, "1", fmt::format("{} {}", text, axis)});
  };
  add("void_ratio_spread", health.spread, "standard deviation of the void ratios of slices across");
  add("void_ratio_deviation", health.largest_deviation, "largest deviation of the void ratio of a slice across");
  add("seam", health.seam, "void ratio of the middle less that of the outer slices across");
  add("lattice_order", health.lattice_order, "order at the wave number of the lattice along");
  add("middle_order", health.middle_order.value, "the same in the middle of the cell along");
  add("largest_order", health.largest_order, "largest order with 8 to 30 waves in the cell along");
}

}  // namespace

std::vector<Metric> metrics_of(const PackingHealth& health) {
  std::vector<Metric> metrics;
  for (int axis = 0; axis < 3; ++axis) add_axis(metrics, health.axes[axis], "xyz"[axis]);
  const auto add = [&](const char* name, double value, const char* units, const char* text) {
    metrics.push_back({name, value, units, text});
  };
  add("void_ratio_counting", health.axes[2].counting, "1",
      "standard deviation of the void ratio of a slice across z of a random packing");
  add("coordination_number", health.network.coordination_number, "1", "mean number of contacts of a mobile grain");
  add("mechanical_coordination_number", health.network.mechanical_coordination_number, "1",
      "the same without grains that have fewer than two");
  add("rattler_share", health.network.rattler_share, "1", "share of the mobile grains with fewer than two contacts");
  add("fabric_anisotropy", health.network.fabric_anisotropy, "1", "deviator of the fabric of contacts, 0 to 1");
  add("lower_half_normal_stress", health.lower_half.normal, "Pa", "normal stress of the lower half at rest");
  add("upper_half_normal_stress", health.upper_half.normal, "Pa", "normal stress of the upper half at rest");
  add("lower_half_shear_stress", health.lower_half.shear, "Pa", "shear stress of the lower half at rest");
  add("upper_half_shear_stress", health.upper_half.shear, "Pa", "shear stress of the upper half at rest");
  return metrics;
}

}  // namespace flowslide
