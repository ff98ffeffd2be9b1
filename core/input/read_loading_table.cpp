// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_loading_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "configuration/error.hpp"
#include "configuration/text_file.hpp"

namespace flowslide {
namespace {

/// Reads one word as a finite number. Throws ConfigurationError for any other word.
double number_of(std::string_view word, const std::string& place) {
  std::string_view digits = word;
  if (digits.starts_with('+') && !digits.starts_with("+-")) digits.remove_prefix(1);
  double value = std::nan("");
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || end != digits.data() + digits.size() || !std::isfinite(value))
    throw ConfigurationError(fmt::format("{}: \"{}\" is not a finite number; give a time in s and a stress in Pa, such "
                                         "as \"0.5 1200\"", place, word));
  return value;
}

/// The words of a line before its comment.
std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view blanks = " \t\r\v\f";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> words;
  while (true) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty()) return words;
    words.push_back(line.substr(0, line.find_first_of(blanks)));
    line.remove_prefix(words.back().size());
  }
}

}  // namespace

StressTable read_loading_table(const std::filesystem::path& file) {
  return loading_table_of(read_text_file(file, "a loading table"), file.string());
}

StressTable loading_table_of(std::string_view text, const std::string& origin) {
  StressTable table;
  for (int number = 1; !text.empty(); ++number) {
    const std::string place = fmt::format("{}:{}", origin, number);
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::vector<std::string_view> words = words_of(line);
    if (words.empty()) continue;
    if (words.size() != 2)
      throw ConfigurationError(fmt::format("{}: a row of a loading table is two numbers: a time in s and a stress in "
                                           "Pa, such as \"0.5 1200\"", place));
    const double now = number_of(words[0], place);
    if (!table.time.empty() && now <= table.time.back())
      throw ConfigurationError(fmt::format("{}: the time {} s does not come after {} s; sort the rows by time and "
                                           "give each time once", place, now, table.time.back()));
    table.time.push_back(now);
    table.change.push_back(number_of(words[1], place));
  }
  if (table.time.empty())
    throw ConfigurationError(
        fmt::format("{}: the loading table is empty; give rows of a time in s and a stress in Pa", origin));
  return table;
}

}  // namespace flowslide
