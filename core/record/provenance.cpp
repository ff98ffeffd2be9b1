// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/provenance.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <ctime>

#include "record/build_information.hpp"

namespace flowslide {
namespace {

std::string host_name() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "unknown";
}

std::string universal_time(std::time_t time) {
  std::tm utc{};
  ::gmtime_r(&time, &utc);
  char text[sizeof "2025-01-31T12:00:00Z and room"] = {};
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

std::string quoted(const std::string& word) {
  constexpr const char* plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

}  // namespace

std::string shell_line(std::span<const char* const> arguments) {
  std::string line;
  for (const char* argument : arguments) {
    if (!line.empty()) line += ' ';
    line += quoted(argument);
  }
  return line;
}

Provenance start_provenance(std::span<const char* const> arguments) {
  Provenance provenance;
  provenance.code_version = build_information::code_version;
  provenance.git_revision = build_information::git_revision;
  provenance.git_state = build_information::git_state;
  provenance.compiler = build_information::compiler;
  provenance.compiler_flags = build_information::compiler_flags;
  provenance.build_type = build_information::build_type;
  provenance.paper_doi = build_information::paper_doi;
  provenance.host = host_name();
  provenance.command_line = shell_line(arguments);
  // std::time() may lag this clock by some milliseconds, and thus show the second before.
  provenance.start_time = universal_time(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now()));
  return provenance;
}

}  // namespace flowslide
