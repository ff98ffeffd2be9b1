// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sealed_file.hpp"

#include <fmt/format.h>

#include "record/hash.hpp"

namespace flowslide {
namespace {

std::string seal_of(std::string_view content) { return "\nflowslide xxh3 " + hash_of(content) + "\n"; }

}  // namespace

void write_sealed(const std::filesystem::path& path, std::string_view content, IfExists if_exists) {
  std::string bytes(content);
  bytes += seal_of(content);
  write_atomically(path, bytes, if_exists);
}

std::string read_sealed(const std::filesystem::path& path, std::string_view remedy) {
  std::string bytes = read_file(path);
  const auto refuse = [&](std::string_view reason) {
    throw CorruptFileError(fmt::format("{} {}; {}", path.string(), reason, remedy));
  };
  if (bytes.size() < seal_size) refuse("is truncated");
  const std::string seal = bytes.substr(bytes.size() - seal_size);
  bytes.resize(bytes.size() - seal_size);
  if (!seal.starts_with("\nflowslide xxh3 ")) refuse("is truncated, altered or not a file of flowslide");
  if (seal != seal_of(bytes)) refuse("is damaged: its checksum does not fit its content");
  return bytes;
}

}  // namespace flowslide
