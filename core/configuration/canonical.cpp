// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/canonical.hpp"

#include <fmt/format.h>


namespace flowslide {

std::string canonical(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";  // the n is that of inf and nan
  return text;
}

std::string canonical(std::int64_t value) { return fmt::format("{}", value); }

std::string canonical(bool value) { return value ? "true" : "false"; }

std::string canonical(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      quoted += fmt::format("\\u{:04X}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace flowslide
