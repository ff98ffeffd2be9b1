// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr const char* delete_or_rename = "delete it or choose another name";

std::string remedy_for(int error) {
  switch (error) {
    case ENOSPC: case EDQUOT: case EFBIG: return "free some space or choose another folder";
    case ENOENT: case ENOTDIR: return "create the folder or choose another one";
    case EACCES: case EPERM: case EROFS: return "choose a folder that you may write";
    case EEXIST: return delete_or_rename;
    default: return "check the file system";
  }
}

[[noreturn]] void fail_to_write(const fs::path& path, int error) {
  throw FileError(fmt::format("cannot write {}: {}; {}", path.string(), std::strerror(error), remedy_for(error)));
}

/// A new file in the folder of `path`, removed again unless it was published.
class AsideFile {
 public:
  explicit AsideFile(const fs::path& path) : target_(path) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      const auto name = fmt::format(".{}.{}.{}.partial", path.filename().string(), ::getpid(), attempt);
      aside_ = path.parent_path() / name;
      descriptor_ = ::open(aside_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      if (descriptor_ >= 0 || errno != EEXIST) break;
    }
    if (descriptor_ < 0) fail_to_write(target_, errno);
  }
  AsideFile(const AsideFile&) = delete;
  AsideFile& operator=(const AsideFile&) = delete;
  ~AsideFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!published_) ::unlink(aside_.c_str());
  }

  void write(std::string_view content) {
    while (!content.empty()) {
      const auto written = ::write(descriptor_, content.data(), content.size());
      if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
      else if (written == 0 || errno != EINTR) fail_to_write(target_, written == 0 ? ENOSPC : errno);
    }
    if (::fsync(descriptor_) != 0) fail_to_write(target_, errno);
    // Some network file systems report a full disk only here.
    if (::close(std::exchange(descriptor_, -1)) != 0) fail_to_write(target_, errno);
  }

  void publish(IfExists if_exists) {
    if (!rename(if_exists)) fail_to_write(target_, errno);
    published_ = true;
    sync_folder();
  }

 private:
  bool rename(IfExists if_exists) const {
    if (if_exists == IfExists::replace) return ::rename(aside_.c_str(), target_.c_str()) == 0;
    if (::renameat2(AT_FDCWD, aside_.c_str(), AT_FDCWD, target_.c_str(), RENAME_NOREPLACE) == 0) return true;
    if (errno != EINVAL && errno != ENOSYS) return false;
    // This file system does not support RENAME_NOREPLACE. A hard link refuses an existing name as well.
    if (::link(aside_.c_str(), target_.c_str()) != 0) return false;
    ::unlink(aside_.c_str());
    return true;
  }

  /// Makes the new name survive a crash; the content is on disk already. File systems may not support this, so errors
  /// are ignored.
  void sync_folder() const {
    const auto folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return;
    ::fsync(descriptor);
    ::close(descriptor);
  }

  fs::path target_, aside_;
  int descriptor_ = -1;
  bool published_ = false;
};

void check_target(const fs::path& path, IfExists if_exists) {
  if (!path.has_filename()) throw FileError(fmt::format("cannot write '{}': it names no file", path.string()));
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0) return;
  if (if_exists == IfExists::refuse)
    throw FileError(fmt::format("{} exists already and is not overwritten; {}", path.string(), delete_or_rename));
  if (!S_ISREG(status.st_mode))
    throw FileError(fmt::format("cannot write {}: it is not a regular file; choose another name", path.string()));
}

struct Descriptor {
  int value;
  ~Descriptor() {
    if (value >= 0) ::close(value);
  }
};

}  // namespace

void write_atomically(const fs::path& path, std::string_view content, IfExists if_exists) {
  check_target(path, if_exists);
  AsideFile file(path);
  file.write(content);
  file.publish(if_exists);
}

std::string read_file(const fs::path& path) {
  const auto fail = [&](int error) {
    throw FileError(fmt::format("cannot read {}: {}", path.string(), std::strerror(error)));
  };
  // O_NONBLOCK: opening a named pipe would otherwise wait for a writer.
  const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
  if (file.value < 0) fail(errno);
  struct stat status {};
  if (::fstat(file.value, &status) != 0) fail(errno);
  if (!S_ISREG(status.st_mode)) throw FileError(fmt::format("cannot read {}: not a regular file", path.string()));
  std::string content(static_cast<std::size_t>(status.st_size), '\0');
  std::size_t size = 0;
  while (size < content.size()) {
    const auto count = ::read(file.value, content.data() + size, content.size() - size);
    if (count > 0) size += static_cast<std::size_t>(count);
    else if (count == 0) break;
    else if (errno != EINTR) fail(errno);
  }
  content.resize(size);
  return content;
}

}  // namespace flowslide
