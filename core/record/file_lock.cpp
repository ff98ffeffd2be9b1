// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/file_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <string_view>
#include <utility>

#include "record/atomic_file.hpp"

namespace flowslide {
namespace {

int open_lock(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor >= 0) return descriptor;
  const int reason = errno;
  // A lock file of another user can be locked without write permission.
  const int readable = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  if (readable >= 0 && reason != EISDIR) return readable;
  if (readable >= 0) ::close(readable);
  throw FileError(fmt::format("cannot create the lock {}: {}; choose a folder that you may write", path.string(),
                              std::strerror(reason)));
}

std::string this_machine() {
  std::array<char, 256> name{};
  ::gethostname(name.data(), name.size() - 1);
  return name.data();
}

/// Returns false if another process holds the lock. Any other error means that this file system has no locks.
bool take(int descriptor, int operation) {
  while (::flock(descriptor, operation) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) return true;
  }
  return true;
}

}  // namespace

std::optional<FileLock> FileLock::try_lock(const std::filesystem::path& path) {
  FileLock lock(open_lock(path));
  if (!take(lock.descriptor_, LOCK_EX | LOCK_NB)) return std::nullopt;
  lock.sign();
  return lock;
}

/// Writes process number and machine into the lock file. Errors are ignored: the lock works without this text.
void FileLock::sign() const {
  const std::string text = fmt::format("{} {}\n", ::getpid(), this_machine());
  const bool written = ::ftruncate(descriptor_, 0) == 0 &&
                       ::pwrite(descriptor_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
  static_cast<void>(written);
}

std::string FileLock::holder(const std::filesystem::path& path) {
  const std::string unknown = "another process";
  std::string text;
  try {
    text = read_file(path);
  } catch (const FileError&) {
    return unknown;
  }
  pid_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view rest(end, static_cast<std::size_t>(text.data() + text.size() - end));
  if (error != std::errc{} || number <= 0 || rest.size() < 3 || rest.front() != ' ' || rest.back() != '\n')
    return unknown;
  const std::string_view machine = rest.substr(1, rest.size() - 2);
  // If the process in the file has ended, the present holder could not write its own number, and is unknown.
  if (machine == this_machine() && ::kill(number, 0) != 0 && errno == ESRCH) return unknown;
  return fmt::format("process {} on {}", number, machine);
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
