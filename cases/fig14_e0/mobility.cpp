// SPDX-License-Identifier: GPL-2.0-or-later
#include "mobility.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace flowslide {
namespace {

constexpr const char* loosest = "790";
constexpr const char* void_ratios[] = {loosest, "771", "765", "751"};

/// The slides "<scheme>_e0_<name>"; without results if there are none.
const Ensemble& ensemble(const Ensembles& slides, const std::string& scheme, const std::string& name) {
  static const Ensemble none;
  const auto found = slides.find(scheme + "_e0_" + name);
  return found == slides.end() ? none : found->second;
}

void add_shares(const Ensembles& slides, const std::string& quantity, const std::string& metric,
                std::map<std::string, double>& metrics) {
  const auto median = [&](const std::string& scheme, const std::string& name) {
    return statistics_of(ensemble(slides, scheme, name), metric).median;
  };
  for (const std::string name : void_ratios) {
    for (const char* scheme : {"RD", "RI"})
      metrics[fmt::format("{}_{}_{}_share", scheme, name, quantity)] =
          median(scheme, name) / median(scheme, loosest);
    metrics[fmt::format("RD_{}_{}_over_RI", name, quantity)] =
        paired_ratio(ensemble(slides, "RD", name), ensemble(slides, "RI", name), metric).median;
  }
}

}  // namespace

void compare_void_ratios(const Ensembles& slides, std::map<std::string, double>& metrics) {
  add_shares(slides, "velocity", "largest_velocity", metrics);
  add_shares(slides, "runout", "runout", metrics);
  for (const std::string name : void_ratios) {
    const Ensemble &rd = ensemble(slides, "RD", name), &ri = ensemble(slides, "RI", name);
    metrics[name + "_largest_runout"] =
        std::fmax(statistics_of(rd, "runout").highest, statistics_of(ri, "runout").highest);
    const Statistics differences = paired_difference(rd, ri, "runout");
    metrics[name + "_runout_difference"] = std::max(std::abs(differences.lowest), std::abs(differences.highest));
  }
}

}  // namespace flowslide
