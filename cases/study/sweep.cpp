// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "sweep_keys.hpp"
#include "sweep_values.hpp"

namespace flowslide {

std::string Sweep::axis_label() const {
  std::string words = name;
  std::replace(words.begin(), words.end(), '_', ' ');
  return unit.empty() ? words : fmt::format("{} ({})", words, unit);
}

std::string Sweep::target(const std::string& run, const std::string& sample) const {
  if (table.empty()) return fmt::format("point.{}.sample", run);
  if (table == "coupling") return fmt::format("point.{}.coupling.{}", run, name);  // nearer than [scheme.<name>]
  if (table == "sample") return fmt::format("sample.{}.{}", sample, name);
  return table + "." + name;
}

std::vector<std::string> Sweep::replaced(const Configuration& configuration, const std::string& sample) const {
  if (table.empty()) return {"study.sample"};
  std::vector<std::string> keys{table == "sample" ? target("", sample) : table + "." + name};
  if (table == "coupling")
    for (const std::string& scheme : configuration.subtables("scheme"))
      keys.push_back(fmt::format("scheme.{}.{}", scheme, name));
  return keys;
}

Sweep read_sweep(const Configuration& configuration, const std::string& engine, const std::string& sample) {
  const std::vector<std::string> keys = configuration.keys_below("sweep");
  if (keys.empty()) return {};
  Sweep sweep;
  sweep.key = "sweep." + keys.front();
  if (keys.size() > 1)
    configuration.refuse("sweep." + keys.back(), "is the second key of [sweep], and a study sweeps one",
                         "write one file for each sweep, and run each");
  find_swept_key(configuration, engine, sample, sweep);
  read_sweep_values(configuration, sweep);
  return sweep;
}

}  // namespace flowslide
