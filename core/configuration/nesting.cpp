// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/nesting.hpp"

namespace flowslide {
namespace {

/// The offset after the string whose opening quote is at `begin`; npos if the string is not closed.
std::size_t end_of_string(std::string_view toml, std::size_t begin) {
  const char quote = toml[begin];
  const std::string_view triple = quote == '"' ? R"(""")" : "'''";
  const bool many_lines = toml.substr(begin).starts_with(triple);
  for (std::size_t at = begin + (many_lines ? 3 : 1); at < toml.size(); ++at) {
    if (quote == '"' && toml[at] == '\\') {
      ++at;
    } else if (many_lines && toml.substr(at).starts_with(triple)) {
      at += 3;
      // Up to two more quotes belong to the text itself.
      for (int more = 0; more < 2 && at < toml.size() && toml[at] == quote; ++more) ++at;
      return at;
    } else if (!many_lines && toml[at] == quote) {
      return at + 1;
    } else if (!many_lines && toml[at] == '\n') {
      break;
    }
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<std::size_t> too_deep_at(std::string_view toml) {
  int brackets = 0, parts = 1;  // open brackets, and parts of the key at this offset
  for (std::size_t at = 0; at < toml.size();) {
    switch (toml[at]) {
      case '#':
        at = toml.find('\n', at);
        if (at == std::string_view::npos) return std::nullopt;
        continue;
      case '"':
      case '\'':
        at = end_of_string(toml, at);
        if (at == std::string_view::npos) return std::nullopt;
        continue;
      case '[':
      case '{':
        if (++brackets > most_nesting) return at;
        parts = 1;
        break;
      case ']':
      case '}':
        if (brackets > 0) --brackets;
        parts = 1;
        break;
      case '.':
        if (++parts > most_nesting) return at;
        break;
      case '\n':
      case '=':
      case ',': parts = 1; break;
      default: break;
    }
    ++at;
  }
  return std::nullopt;
}

}  // namespace flowslide
