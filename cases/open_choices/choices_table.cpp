// SPDX-License-Identifier: GPL-2.0-or-later
#include "choices_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace flowslide {
namespace {

/// The choices of case.toml, in the order of the table.
constexpr std::array choices{
    std::pair{"plain", "none"},
    std::pair{"torsion", "torsion resistance"},
    std::pair{"limited", "normal force limited"},
    std::pair{"glue", "glue: outer 5 % of the height"},
    std::pair{"height", "strain between the glued layers"},
    std::pair{"stiffness_1", "rolling stiffness 1"},
    std::pair{"stiffness_5", "rolling stiffness 5"},
    std::pair{"damping_0", "rolling damping 0"},
    std::pair{"damping_05", "rolling damping 0.5"},
    std::pair{"drag_half", "half the drag, same e_0"},
    std::pair{"drag_double", "twice the drag, same e_0"},
    std::pair{"stale", "stale histories (stock LIGGGHTS)"},
    std::pair{"time_step", "dt_L = 5e-7 s"},
    std::pair{"rest", "RI rests while liquefied"},
};

/// The first result of a run; null if there is none.
const Result* result_of(const Ensembles& runs, const std::string& name) {
  const auto found = runs.find(name);
  return found == runs.end() ? nullptr : &found->second.front();
}

std::string number(const Result* result, const char* metric, const char* format, double factor = 1.0) {
  const double value = result == nullptr ? std::nan("") : metric_of(*result, metric);
  return std::isfinite(value) ? fmt::format(fmt::runtime(format), factor * value) : "-";
}

/// What a sample does after its peak.
std::string class_of(const Result* shear) {
  if (shear == nullptr) return "-";
  if (!std::isfinite(metric_of(*shear, "liquefied_strain"))) return "does not liquefy";
  if (metric_of(*shear, "jams") == 1.0) return "jams from " + number(shear, "strain_above_10", "{:.0f} %", 100.0);
  return fmt::format("liquid to {:.0f} %", 100.0 * shear->series.last("shear_strain"));
}

/// The median over the samples of a velocity, m/s. A slope at rest swings a little: no "-0.00".
std::string velocity(const Ensemble& slides, const char* metric) {
  const double median = statistics_of(slides, metric).median;
  return std::isfinite(median) ? fmt::format("{:.2f}", std::abs(median) < 0.005 ? 0.0 : median) : "-";
}

/// The velocity when the pulse ends, the largest, and how many slopes stand at the end.
std::string velocities(const Ensembles& runs, const std::string& name) {
  const auto found = runs.find(name);
  if (found == runs.end()) return "-";
  const Ensemble& slides = found->second;
  const std::vector<double> standing = values_of(slides, "stands");
  return fmt::format("{}, {}; {:.0f} of {} stand", velocity(slides, "velocity_after_pulse"),
                     velocity(slides, "largest_velocity"), std::accumulate(standing.begin(), standing.end(), 0.0),
                     slides.size());
}

}  // namespace

std::string choices_table(const Ensembles& runs) {
  std::string table =
      "| sample | choice | e_0 of cell, probe | peak (kPa) | course | tau above 1 % from (%) | RD: v after the pulse, "
      "largest v (m/s) | RI |\n|---|---|---|---|---|---|---|---|\n";
  for (const std::string sample : {"771", "765"})
    for (const auto& [name, text] : choices) {
      const std::string stem = fmt::format("{}_{}_", name, sample);
      const Result* shear = result_of(runs, stem + "shear");
      const Result* any = shear;
      for (const char* scheme : {"RD", "RI"})
        if (any == nullptr) any = result_of(runs, stem + scheme);
      if (any == nullptr) continue;
      table +=
          fmt::format("| 0.{} | {} | {}, {} | {} | {} | {} | {} | {} |\n", sample, text,
                      number(any, "initial_void_ratio", "{:.3f}"), number(any, "initial_probe_void_ratio", "{:.3f}"),
                      number(shear, "peak_shear_stress", "{:.1f}", 1e-3), class_of(shear),
                      number(shear, "strain_above_1", "{:.0f}", 100.0), velocities(runs, stem + "RD"),
                      velocities(runs, stem + "RI"));
    }
  return table;
}

}  // namespace flowslide
