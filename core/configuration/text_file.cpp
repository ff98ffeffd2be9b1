// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/text_file.hpp"

#include <fmt/format.h>

#include <array>
#include <fstream>
#include <string_view>

#include "configuration/error.hpp"

namespace flowslide {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view mark_of_utf8 = "\xEF\xBB\xBF";
/// Byte-order marks of UTF-16 and UTF-32. The mark of little-endian UTF-32 begins with that of UTF-16.
constexpr std::array marks_of_others{"\xFF\xFE"sv, "\xFE\xFF"sv, "\0\0\xFE\xFF"sv};

}  // namespace

std::string read_text_file(const std::filesystem::path& file, const std::string& wanted) {
  const auto refuse = [&](const std::string& problem) {
    throw ConfigurationError(fmt::format("{}: {}", file.string(), problem));
  };
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(file, failure);
  if (std::filesystem::is_directory(status))
    refuse(fmt::format("is a folder, but {} is needed; give the path of the file", wanted));
  if (std::filesystem::is_other(status))
    refuse(fmt::format("is a pipe, a socket or a device, but {} is needed; write it to a file first", wanted));
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 65536> part;
  while (stream) {
    stream.read(part.data(), part.size());
    text.append(part.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (!stream.is_open() || stream.bad()) refuse("cannot be read; check the path and its permissions");
  for (const std::string_view mark : marks_of_others)
    if (text.starts_with(mark)) refuse("is UTF-16 or UTF-32; save it as UTF-8");
  if (text.starts_with(mark_of_utf8)) text.erase(0, mark_of_utf8.size());
  return text;
}

}  // namespace flowslide
