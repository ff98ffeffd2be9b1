// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "convergence.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr std::array<std::pair<const char*, const char*>, 4> passings{{{"RI", "eq. 15"},
                                                                       {"reset", "eq. 18 as printed"},
                                                                       {"carry", "remainder carried"},
                                                                       {"variable", "eq. 17"}}};

std::string cell(const std::map<std::string, double>& metrics, const std::string& slide) {
  const auto error = metrics.find(slide + ".error"), rate = metrics.find(slide + ".rate_share");
  if (error == metrics.end()) return "";
  return rate == metrics.end() ? fmt::format("{:.2g}", error->second)
                               : fmt::format("{:.2g} ({:.3g})", error->second, rate->second);
}

bool is_shown(const std::string& passing) {
  return std::any_of(passings.begin(), passings.end(), [&](const auto& shown) { return shown.first == passing; });
}

/// "1e-3", "2.5e-4".
std::string scientific(double value) {
  const double exponent = std::floor(std::log10(value) + 1e-9);
  return fmt::format("{:.3g}e{:.0f}", value / std::pow(10.0, exponent), exponent);
}

}  // namespace

std::string error_table(const Ensembles& slides, const std::map<std::string, double>& metrics) {
  std::map<double, std::map<std::string, std::string>, std::greater<>> rows;  // dt_G -> passing -> cell
  for (const auto& [name, ensemble] : slides) {
    const std::string text = is_shown(passing_of(name)) ? cell(metrics, name) : "";
    if (!text.empty() && alone_of(ensemble, slides) == "DEM_high")
      rows[parameter_of(ensemble, "time_step")][passing_of(name)] = text;
  }
  if (rows.empty()) return "";
  std::string text = "| dt_G (s) |", rule = "|---|";
  for (const auto& [passing, title] : passings) {
    text += fmt::format(" {} |", title);
    rule += "---|";
  }
  text += "\n" + rule + "\n";
  for (const auto& [time_step, cells] : rows) {
    text += fmt::format("| {} |", scientific(time_step));
    for (const auto& [passing, title] : passings)
      text += fmt::format(" {} |", cells.contains(passing) ? cells.at(passing) : "");
    text += "\n";
  }
  return text;
}

std::string error_rows(const Ensembles& slides, const std::map<std::string, double>& metrics) {
  std::string text = table_head({{"passing", "", "text", "rule that passes strain", "", {}},
                                 {"time_step", "dt_G", "s", "global time step", "", {}},
                                 {"error", "", "1", "error of tau against DEM_high, median of the replicates", "", {}},
                                 {"highest", "", "1", "highest error of the replicates", "", {}},
                                 {"spread", "", "1", "spread of tau between the samples of DEM_high", "", {}}});
  const auto value = [&](const std::string& name) {
    const auto found = metrics.find(name);
    return found == metrics.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
  };
  std::map<std::string, std::map<double, std::string>> rows;  // passing -> dt_G -> row
  for (const auto& [name, ensemble] : slides) {
    const std::string passing = passing_of(name);
    if (!is_shown(passing) || !metrics.contains(name + ".error") || alone_of(ensemble, slides) != "DEM_high") continue;
    const double step = parameter_of(ensemble, "time_step");
    rows[passing][step] = fmt::format("{} {} {} {} {}\n", passing, step, value(name + ".error"),
                                      value(name + ".error.highest"), value("DEM_high.spread"));
  }
  for (const auto& [passing, by_step] : rows)
    for (const auto& [step, row] : by_step) text += row;
  return text;
}

}  // namespace flowslide
