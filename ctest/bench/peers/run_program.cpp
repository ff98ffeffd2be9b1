// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/run_program.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "support/process.hpp"

namespace flowslide {
namespace {

std::vector<std::string> noted;

/// The last lines of a text.
std::string end_of(const std::string& text) {
  constexpr std::size_t lines = 5;
  std::size_t begin = text.size();
  for (std::size_t line = 0; line <= lines && begin > 0 && begin != std::string::npos; ++line)
    begin = text.rfind('\n', begin - 1);
  return begin == std::string::npos ? text : text.substr(begin);
}

}  // namespace

void note_environment() {
  noted.clear();
  for (char** entry = environ; *entry; ++entry) noted.emplace_back(*entry);
}

bool is_installed(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
  return false;
}

std::string run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                        const std::string& log) {
  std::vector<char*> environment;
  for (std::string& entry : noted) environment.push_back(entry.data());
  environment.push_back(nullptr);
  Process process(words, folder / log, [&] {
    if (::chdir(folder.c_str()) != 0) ::_exit(126);
    if (!noted.empty()) environ = environment.data();
  });
  const int code = process.wait();
  std::string said = process.said();
  if (code != 0) throw std::runtime_error(fmt::format("{} ended with {}:{}", words.front(), code, end_of(said)));
  return said;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  if (!(stream << text) || !stream.flush()) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace flowslide
