// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "app/error.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr const char* mark_folder = ".flowslide";
constexpr const char* case_file = "case";

[[noreturn]] void fail_to_write(const fs::path& file, int cause) {
  throw OutputError(fmt::format("{}: cannot be written: {}", file.string(), std::strerror(cause)));
}

/// A file being written aside; it is removed again unless it was kept.
class FileAside {
 public:
  explicit FileAside(const fs::path& file) : target_(file), path_(file.string() + fmt::format(".{}.part", ::getpid())) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail_to_write(target_, errno);
  }
  ~FileAside() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!kept_) ::unlink(path_.c_str());
  }
  FileAside(const FileAside&) = delete;
  FileAside& operator=(const FileAside&) = delete;

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = ::write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) fail_to_write(target_, errno);
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (::fsync(descriptor_) != 0) fail_to_write(target_, errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail_to_write(target_, errno);
  }

  void put_in_place(Overwrite overwrite) {
    if (overwrite == Overwrite::replace) {
      if (::rename(path_.c_str(), target_.c_str()) != 0) fail_to_write(target_, errno);
      kept_ = true;
    } else if (::link(path_.c_str(), target_.c_str()) != 0) {  // fails, in one step, when the target is there
      if (errno != EEXIST) fail_to_write(target_, errno);
      throw OutputError(fmt::format("{}: is there already and is not overwritten; remove it or choose another --output",
                                    target_.string()));
    }
    sync_folder();
  }

 private:
  void sync_folder() const {
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;  // the file is in place; a folder that cannot be read is no loss
    ::fsync(descriptor);
    ::close(descriptor);
  }

  fs::path target_;
  fs::path path_;
  int descriptor_ = -1;
  bool kept_ = false;
};

[[noreturn]] void refuse(const fs::path& path, const std::string& problem) {
  throw ConfigurationError(
      fmt::format("the output folder {} {}; choose another with --output", path.string(), problem));
}

std::string read_line(const fs::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// The case that a folder is marked with; empty when it has no mark.
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
    refuse(path,
           fmt::format("holds files that this program did not write, such as {}", entry.path().filename().string()));
  }
}

}  // namespace

void write_atomically(const fs::path& file, std::string_view text, Overwrite overwrite) {
  FileAside aside(file);
  aside.write(text);
  aside.put_in_place(overwrite);
}

OutputFolder OutputFolder::open(const fs::path& path, const std::string& case_name) {
  check_is_folder(path);
  std::error_code failure;
  if (fs::exists(path, failure)) {
    check_case(path, case_name);
    check_foreign_files(path);
  }
  fs::create_directories(path / mark_folder, failure);
  if (failure) refuse(path, fmt::format("cannot be written: {}", failure.message()));
  try {  // also on a marked folder: it tells before a run, not after, that nothing can be written
    write_atomically(path / mark_folder / case_file, case_name + "\n");
  } catch (const OutputError& error) {
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

std::string OutputFolder::hash_of(const std::string& point) const {
  return read_line(path_ / mark_folder / (point + ".hash"));
}

void OutputFolder::begin_point(const std::string& point, const std::string& hash) const {
  const auto allowed = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  };
  if (point.empty() || !std::all_of(point.begin(), point.end(), allowed))
    throw std::invalid_argument(fmt::format("\"{}\" is no name of a point", point));
  const std::string before = hash_of(point);
  if (!before.empty() && before != hash) {
    refuse(path_, fmt::format("holds the point \"{}\" of another configuration (hash {}, now {}), which is not "
                              "overwritten",
                              point, before, hash));
  }
  write_atomically(path_ / mark_folder / (point + ".hash"), hash + "\n");
}

}  // namespace flowslide
