// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/loading_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "app/error.hpp"

namespace flowslide {
namespace {

/// Reads one word as a number; a word that is none, or not finite, is refused.
double number_of(const std::string& word, const std::string& place) {
  std::size_t used = 0;
  double value = std::nan("");
  try {
    value = std::stod(word, &used);
  } catch (const std::logic_error&) {  // no number, or beyond a double
  }
  if (used != word.size() || !std::isfinite(value))
    throw ConfigurationError(fmt::format("{}: \"{}\" is not a finite number; give a time in s and a stress in Pa, such "
                                         "as \"0.5 1200\"", place, word));
  return value;
}

}  // namespace

StressTable read_loading_table(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw ConfigurationError(fmt::format("{}: the loading table cannot be read; check the path", file.string()));
  StressTable table;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    const std::string place = fmt::format("{}:{}", file.string(), number);
    std::istringstream words(line.substr(0, line.find('#')));
    std::string time, change, more;
    if (!(words >> time)) continue;
    if (!(words >> change) || words >> more)
      throw ConfigurationError(fmt::format("{}: a row of a loading table is two numbers: a time in s and a stress in "
                                           "Pa, such as \"0.5 1200\"", place));
    const double now = number_of(time, place);
    if (!table.time.empty() && now <= table.time.back())
      throw ConfigurationError(fmt::format("{}: the time {} s does not come after {} s; sort the rows by time and "
                                           "leave no time twice", place, now, table.time.back()));
    table.time.push_back(now);
    table.change.push_back(number_of(change, place));
  }
  if (table.time.empty())
    throw ConfigurationError(fmt::format("{}: the loading table is empty; give rows of a time in s and a stress in Pa",
                                         file.string()));
  return table;
}

InputTable input_table(const std::string& file, const StressTable& table) {
  Series rows;
  rows.axis.values = table.time;
  rows.columns = {
      {"stress_change", "Delta tau_d", "Pa", "change of the driving shear stress", "positive downslope", table.change}};
  return {"loading", file, std::move(rows)};
}

StressTable stress_table(const InputTable& input) {
  return {input.rows.column("time").values, input.rows.column("stress_change").values};
}

}  // namespace flowslide
