// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/peer_table.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace flowslide {
namespace {

/// Whether `row` is this engine of the project, with as many threads and the same rolling part as `other`.
bool is_counterpart(const PeerRow& row, const std::string& engine, const PeerRow& other) {
  const std::string& name = row.code->name;
  const bool mixed = name.starts_with("native-mixed");
  return name.starts_with("native") && mixed == (engine == "native-mixed") &&
         row.code->threads == other.code->threads && row.code->rolling == other.code->rolling;
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double times_slower(const PeerRow& row, const std::string& engine, const std::vector<PeerRow>& rows) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const PeerRow& r) { return is_counterpart(r, engine, row); });
  if (found == rows.end()) return 0.0;
  std::vector<double> ratios;
  for (std::size_t turn = 0; turn < row.speeds.size(); ++turn) ratios.push_back(found->speeds[turn] / row.speeds[turn]);
  return median(ratios);
}

std::string speed_header() {
  return "| N | state | contacts | code | cores | steps/s | ns per contact and step | native / code | native-mixed / "
         "code |\n"
         "|---|---|---|---|---|---|---|---|---|\n";
}

std::string speed_lines(const PeerScene& scene, const std::vector<PeerRow>& rows) {
  std::string lines;
  const auto ratio = [](double value) { return value > 0.0 ? fmt::format("{:.2f}", value) : std::string("-"); };
  for (const PeerRow& row : rows) {
    const double speed = median(row.speeds);
    lines += fmt::format("| {} | {} | {} | {} | {} | {:.3g} | {:.1f} | {} | {} |\n", scene.sample.assembly.size(),
                         scene.name, scene.contacts, row.code->name, row.code->threads, speed,
                         1e9 / (speed * static_cast<double>(scene.contacts)), ratio(times_slower(row, "native", rows)),
                         ratio(times_slower(row, "native-mixed", rows)));
  }
  return lines;
}

std::string stress_header() {
  return "| N | state | code | sigma (Pa) | tau (Pa) | sigma by its law | tau by its law | sigma by ours | tau by ours "
         "| "
         "error |\n|---|---|---|---|---|---|---|---|---|---|\n";
}

std::string stress_lines(const PeerScene& scene, const std::vector<PeerRow>& rows) {
  std::string lines;
  for (const PeerRow& row : rows) {
    const FirstState& s = row.first;
    lines += fmt::format("| {} | {} | {} | {:.9g} | {:.9g} | {:.9g} | {:.9g} | {:.9g} | {:.9g} | {:.1e} |\n",
                         scene.sample.assembly.size(), scene.name, row.code->name, s.found.normal, s.found.shear,
                         s.expected.normal, s.expected.shear, s.ours.normal, s.ours.shear, s.error);
  }
  return lines;
}

}  // namespace flowslide
