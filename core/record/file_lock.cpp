// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "record/atomic_file.hpp"

namespace flowslide {
namespace {

int open_lock(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor < 0)
    throw FileError(fmt::format("cannot create the lock {}: {}; choose a folder that you may write", path.string(),
                                std::strerror(errno)));
  return descriptor;
}

/// False if another process holds it. An error other than that means that this file system has no locks.
bool take(int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) return true;
  }
  return true;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& path) : descriptor_(open_lock(path)) { take(descriptor_, LOCK_EX); }

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path) {
  FileLock lock(open_lock(path));
  if (!take(lock.descriptor_, LOCK_EX | LOCK_NB)) return std::nullopt;
  return lock;
}

bool FileLock::is_held(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const FileLock looking(descriptor);
  return !take(descriptor, LOCK_SH | LOCK_NB);
}

FileLock::FileLock(FileLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FileLock& FileLock::operator=(FileLock&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

FileLock::~FileLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace flowslide
