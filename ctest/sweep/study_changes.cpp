// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep/study_changes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace flowslide {
namespace {

const std::vector<double> factors{0.5, 0.8, 0.95, 1.05, 1.25, 2.0};

/// A number at the beginning of a text, and the rest of the text.
struct Number {
  double value = 0.0;
  bool whole = false;
  std::string rest;
};

std::optional<Number> number_in(const std::string& text) {
  Number number;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number.value);
  if (error != std::errc{}) return std::nullopt;
  const std::string digits(text.data(), end);
  number.whole = digits.find_first_of(".en") == std::string::npos;
  number.rest = end;
  return number;
}

std::string changed_number(const Number& number, Dice& dice) {
  if (number.whole && number.rest.empty()) {
    const auto value = static_cast<std::int64_t>(number.value);
    return fmt::format("{}", dice.one_of(std::vector<std::int64_t>{value - 1, value + 1, 2 * value, value / 2}));
  }
  return fmt::format("{}{}", number.value * dice.one_of(factors), number.rest);
}

/// The members of a list that holds no list.
std::vector<std::string> members_of(std::string_view list) {
  std::vector<std::string> members(1);
  for (const char c : list.substr(1, list.size() - 2)) {
    if (c == ',') members.emplace_back();
    else if (c != ' ' || !members.back().empty()) members.back() += c;
  }
  return members;
}

}  // namespace

std::vector<Setting> settings_in(std::string_view dry_run) {
  std::vector<Setting> settings;
  while (!dry_run.empty()) {
    const std::string line(dry_run.substr(0, dry_run.find('\n')));
    dry_run.remove_prefix(std::min(line.size() + 1, dry_run.size()));
    if (line.starts_with("# run ")) break;  // the rest is no configuration
    const std::size_t equals = line.find(" = ");
    if (line.starts_with('#') || equals == std::string::npos) continue;
    std::string value = line.substr(equals + 3);
    value.resize(std::min(value.size(), value.rfind(" # ")));  // cuts off the origin
    value.resize(value.find_last_not_of(' ') + 1);
    settings.push_back({line.substr(0, equals), value});
  }
  return settings;
}

std::string changed_value(const std::string& value, Dice& dice) {
  if (value.empty() || value == "[]") return "";
  if (value == "true" || value == "false") return value == "true" ? "false" : "true";
  if (value.front() == '[') {
    std::vector<std::string> members = members_of(value);
    std::string& member = members[dice.below(members.size())];
    member = changed_value(member, dice);
    return member.empty() ? "" : fmt::format("[{}]", fmt::join(members, ", "));
  }
  const bool quoted = value.front() == '"';
  const auto number = number_in(quoted ? value.substr(1, value.size() - 2) : value);
  if (!number || number->value == 0.0) return "";
  const std::string changed = changed_number(*number, dice);
  return quoted ? '"' + changed + '"' : changed;
}

std::vector<Setting> random_changes(const std::vector<Setting>& settings, Dice& dice) {
  const std::size_t wanted = 1 + dice.below(5);
  std::vector<Setting> changes;
  for (int tries = 0; changes.size() < wanted && tries < 100; ++tries) {
    const Setting& setting = dice.one_of(settings);
    const auto same_key = [&](const Setting& other) { return other.key == setting.key; };
    if (std::any_of(changes.begin(), changes.end(), same_key)) continue;
    if (const std::string value = changed_value(setting.value, dice); !value.empty() && value != setting.value)
      changes.push_back({setting.key, value});
  }
  return changes;
}

bool is_of_all_runs(const std::string& key) {
  return key == "replicates" || key.starts_with("sweep.") || key.starts_with("study.");
}

std::vector<Setting> random_sweep(bool of_grains, const std::string& engine, Dice& dice) {
  std::vector<Setting> settings{{"stop.end_time", of_grains ? "\"10 ms\"" : "\"0.2 s\""},
                                {"replicates", dice.one_in(3) ? "2" : "1"},
                                {"study.scheme", dice.one_of(std::vector<std::string>{R"(["RD"])", R"(["RI"])",
                                                                                     R"(["RI", "RD"])"})}};
  std::vector<Setting> sweeps{{"sweep.amplitude", R"("1 kPa", "4 kPa", "2500 Pa")"},
                              {"sweep.n_accum", "5, 40, 20"},
                              {"sweep.coupling.time_step", R"("5e-5 s", "2e-4 s", "1e-4 s")"},
                              {"sweep.hydraulic_conductivity", R"("0 m/s", "1e-4 m/s", "1e-6 m/s")"}};
  if (of_grains) {
    settings.push_back({"packing.lattice", "[5, 5, 6]"});
    settings.push_back({"sample.e0_790.tolerance", "0.3"});
    settings.push_back({"preparation.allow_uneven", "true"});
    sweeps.push_back({"sweep.local_time_step", R"("7e-6 s", "5e-6 s", "6e-6 s")"});
  } else {
    sweeps.push_back({"sweep.angle", R"("4 deg", "3 deg", "4.5 deg")"});
    sweeps.push_back(engine == "elastic" ? Setting{"sweep.elastic.shear_modulus", R"("9 MPa", "15 MPa", "20 MPa")"}
                                         : Setting{"sweep.void_ratio", "0.8, 0.72, 0.76"});
  }
  if (dice.one_in(5)) return settings;
  Setting sweep = dice.one_of(sweeps);
  std::vector<std::string> values = members_of("[" + sweep.value + "]");
  values.resize(1 + dice.below(values.size()));
  settings.push_back({sweep.key, fmt::format("[{}]", fmt::join(values, ", "))});
  return settings;
}

}  // namespace flowslide
