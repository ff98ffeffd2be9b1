// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

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

}  // namespace

std::string error_table(const std::map<std::string, double>& metrics) {
  std::string head = "| dt_G (s) |", rule = "|---|", rows;
  for (const auto& [passing, title] : passings) {
    head += fmt::format(" {} |", title);
    rule += "---|";
  }
  for (const char* time_step : {"1e-3", "1e-4", "1e-5", "1e-6"}) {
    std::string row;
    bool any = false;
    for (const auto& [passing, title] : passings) {
      const std::string text = cell(metrics, fmt::format("{}_high_{}", passing, time_step));
      any = any || !text.empty();
      row += fmt::format(" {} |", text);
    }
    if (any) rows += fmt::format("| {} |{}\n", time_step, row);
  }
  return rows.empty() ? "" : head + "\n" + rule + "\n" + rows;
}

}  // namespace flowslide
