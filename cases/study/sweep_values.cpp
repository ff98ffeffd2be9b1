// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>
#include <set>
#include <stdexcept>

namespace flowslide {
namespace {

/// "3.5 deg" becomes "3p5deg": what a name of a run and of its files may hold.
std::string file_name_of(const std::string& text) {
  std::string name;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_') name += c;
    if (c == '.') name += 'p';
    if (c == '/') name += '_';
  }
  return name;
}

std::optional<Quantity> quantity_in(const std::string& text) {
  try {
    return parse_quantity(text);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

/// The number and the unit of a quantity as written: 3 and "deg".
std::pair<double, std::string> parts_of(const std::string& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  std::string unit(end, text.data() + text.size());
  unit.erase(0, std::min(unit.find_first_not_of(' '), unit.size()));
  return {number, unit};
}

void refuse_equal_values(const Configuration& configuration, const Sweep& sweep) {
  std::set<double> numbers;
  std::set<std::string> names;
  for (const SweepValue& value : sweep.values)
    if (!numbers.insert(value.number).second || !names.insert(value.file_name).second)
      configuration.refuse(sweep.key, fmt::format("gives \"{}\" twice", value.text), "give each value once");
}

}  // namespace

void read_sweep_values(const Configuration& configuration, Sweep& sweep) {
  std::set<std::string> units;
  for (const std::string& text : configuration.items_of(sweep.key)) {
    SweepValue value{sweep.values.size(), text, file_name_of(text), 0.0, 0.0};
    if (const auto quantity = quantity_in(text)) {
      value.number = quantity->value;
      const auto [number, unit] = parts_of(text);
      value.as_written = number;
      if (number != 0.0 || !unit.empty()) units.insert(unit);
      sweep.si_unit = std::max(sweep.si_unit, unit_of(quantity->dimension));  // of "0" it is empty
    } else {
      sweep.is_of_numbers = false;
    }
    sweep.values.push_back(value);
  }
  if (units.size() == 1) sweep.unit = *units.begin();
  if (units.size() > 1) {
    sweep.unit = sweep.si_unit;
    for (SweepValue& value : sweep.values) value.as_written = value.number;
  }
  if (sweep.si_unit.empty()) sweep.si_unit = "1";
  if (!sweep.is_of_numbers) {
    sweep.unit.clear();
    sweep.si_unit = "1";
    double position = 0.0;
    for (SweepValue& value : sweep.values) value.number = value.as_written = ++position;
  }
  refuse_equal_values(configuration, sweep);
  std::ranges::sort(sweep.values, {}, &SweepValue::number);
}

}  // namespace flowslide
