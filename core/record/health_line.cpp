// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/health_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace flowslide {
namespace {

/// The largest magnitude along any axis.
double largest(const std::vector<Metric>& metrics, const std::string& name) {
  double most = 0.0;
  for (const char axis : {'x', 'y', 'z'})
    if (const auto value = value_of(metrics, name + "_" + axis)) most = std::max(most, std::abs(*value));
  return most;
}

}  // namespace

std::string health_line(const std::vector<Metric>& metrics) {
  const auto void_ratio = value_of(metrics, "initial_void_ratio");
  const auto probe = value_of(metrics, "initial_probe_void_ratio");
  const auto contacts = value_of(metrics, "mechanical_coordination_number");
  if (!void_ratio || !probe || !contacts) return "";
  return fmt::format(
      "e0 {:.4f} (probe {:.4f}), slices +-{:.3f}, seam {:.3f}, order {:.3f}, contacts {:.2f}, rattlers {:.1f} %, "
      "fabric {:.3f}",
      *void_ratio, *probe, largest(metrics, "void_ratio_spread"), largest(metrics, "seam"),
      largest(metrics, "middle_order"), *contacts, 100.0 * value_of(metrics, "rattler_share").value_or(0.0),
      value_of(metrics, "fabric_anisotropy").value_or(0.0));
}

}  // namespace flowslide
