// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

#include "process/exit_code.hpp"
#include "record/atomic_file.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_folder = ".flowslide";
constexpr const char* case_file = "case";

[[noreturn]] void refuse(const fs::path& path, const std::string& problem) {
  throw Refused(
      fmt::format("the output folder {} {}; choose another with --output", path.string(), problem));
}

std::string read_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// The name of the case in the mark of a folder; empty without a mark.
std::string marked_case(const fs::path& path) { return read_line(path / mark_folder / case_file); }

void check_is_folder(const fs::path& path) {
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (status.type() == fs::file_type::not_found) return;
  if (failure) refuse(path, fmt::format("cannot be reached: {}", failure.message()));
  if (!fs::is_directory(status)) refuse(path, "is a file, not a folder");
}

void check_case(const fs::path& path, const std::string& case_name) {
  const std::string owner = marked_case(path);
  if (!owner.empty() && owner != case_name)
    refuse(path, fmt::format("holds results of the case \"{}\", not of \"{}\"", owner, case_name));
}

void check_foreign_files(const fs::path& path) {
  if (!marked_case(path).empty()) return;
  std::error_code failure;
  fs::directory_iterator entries(path, failure);
  if (failure) refuse(path, fmt::format("cannot be read: {}", failure.message()));
  for (const fs::directory_entry& entry : entries) {
    if (entry.path().filename() == mark_folder) continue;
    if (!marked_case(path).empty()) return;  // another run of the case has begun meanwhile
    refuse(path,
           fmt::format("holds files that this program did not write, such as {}", entry.path().filename().string()));
  }
}

fs::path note_of(const fs::path& folder, const std::string& point) {
  return folder / mark_folder / (point + ".identity");
}

/// Removes the files that write_atomically leaves when its process is killed. The lock of the run is held, so no other
/// process writes them now.
void remove_half_written(const fs::path& folder, const std::string& point) {
  std::error_code failure;
  std::vector<fs::path> left;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const std::string name = entry.path().filename().string();
    const bool of_point = name.starts_with("." + point + ".") || name.starts_with("." + point + "_profiles.");
    if (of_point && name.ends_with(".partial")) left.push_back(entry.path());
  }
  for (const fs::path& path : left) fs::remove(path, failure);
}

}  // namespace

OutputFolder OutputFolder::open(const fs::path& path, const std::string& case_name) {
  check_is_folder(path);
  std::error_code failure;
  if (fs::exists(path, failure)) {
    check_case(path, case_name);
    check_foreign_files(path);
  }
  fs::create_directories(path / mark_folder, failure);
  if (failure) refuse(path, fmt::format("cannot be written: {}", failure.message()));
  if (!marked_case(path).empty()) {  // report a read-only folder before the run, not after it
    if (::access((path / mark_folder).c_str(), W_OK) != 0)
      refuse(path, fmt::format("cannot be written: {}", std::strerror(errno)));
    return OutputFolder(path);
  }
  try {
    write_atomically(path / mark_folder / case_file, case_name + "\n");
  } catch (const FileError& error) {
    refuse(path, fmt::format("cannot be written ({})", error.what()));
  }
  return OutputFolder(path);
}

OutputFolder OutputFolder::open_existing(const fs::path& path, const std::string& case_name) {
  check_is_folder(path);
  std::error_code failure;
  if (!fs::exists(path, failure)) refuse(path, "is not there: run the case first");
  check_case(path, case_name);
  if (marked_case(path).empty()) refuse(path, fmt::format("holds no results of the case \"{}\"", case_name));
  return OutputFolder(path);
}

bool OutputFolder::has_result(const std::string& point) const {
  return !left_out_.contains(point) && fs::exists(file(point + result_end));
}

std::string OutputFolder::noted(const std::string& point) const {
  const fs::path file = note_of(path_, point);
  return fs::exists(file) ? read_file(file) : "";
}

void OutputFolder::note(const std::string& point, const std::string& identity) const {
  write_atomically(note_of(path_, point), identity);
}

void OutputFolder::remove_point(const std::string& point) const {
  for (const char* end : point_ends) fs::remove_all(file(point + end));
  checkpoints(point).remove();
  fs::remove(note_of(path_, point));
}

fs::path OutputFolder::lock_path(const std::string& point) const { return path_ / mark_folder / (point + ".lock"); }

CheckpointStore OutputFolder::checkpoints(const std::string& point) const { return {path_ / mark_folder, point}; }

FileLock OutputFolder::lock_point(const std::string& point) const {
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  };
  if (point.empty() || !std::all_of(point.begin(), point.end(), allowed))
    throw std::invalid_argument(fmt::format("\"{}\" is no name of a run", point));
  std::optional<FileLock> lock;
  for (int tries = 0; tries < 10 && !lock; ++tries) {  // a process that reads the status holds the lock briefly
    if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    lock = FileLock::try_lock(lock_path(point));
  }
  if (!lock) refuse(path_, fmt::format("is in use: another process executes the run \"{}\" there", point));
  for (const fs::path& folder : {path_, path_ / mark_folder}) remove_half_written(folder, point);
  return *std::move(lock);
}

}  // namespace flowslide
