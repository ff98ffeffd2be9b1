// SPDX-License-Identifier: GPL-2.0-or-later
// What a program of this project can end with: one exit code and at most one message per failure.
#pragma once

#include <exception>
#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

namespace flowslide {

/// What a program returns to the shell. These numbers are part of the interface: scripts and schedulers read them.
enum class ExitCode : int {
  ok = 0,                 ///< all that was asked for is done
  output = 1,             ///< standard output could not be written: what was printed is not complete
  configuration = 2,      ///< bad option, bad configuration file, or an output that cannot be written
  numerical_failure = 3,  ///< the run was stopped with a diagnosis: no result of it may be used
  claim_not_met = 4,      ///< the run is good, but a claim of the paper does not hold in it
  defect = 70,            ///< the program contradicts itself: a defect of it, to be reported
  resumable = 75,         ///< stopped in time; a later call goes on from the checkpoint
  interrupted = 130       ///< ended by the user
};

/// The number that `main` returns.
constexpr int to_int(ExitCode code) { return static_cast<int>(code); }

/// The user asked for something that cannot be done. The message says what was given, what is allowed and the mend.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Not a failure: all that was asked for is a text (help, version). `run_main` prints it to stdout and returns 0.
class FinishedEarly : public std::exception {
 public:
  explicit FinishedEarly(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// A run was stopped before its end, and has kept what it goes on from.
class Stopped : public std::runtime_error {
 public:
  Stopped(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// The first MPI rank has failed with this code, and has said why.
class FirstRankFailed : public std::exception {
 public:
  explicit FirstRankFailed(ExitCode code) : code_(code) {}
  ExitCode code() const { return code_; }
  const char* what() const noexcept override { return "the first rank failed"; }

 private:
  ExitCode code_;
};

/// The exit code of a failure, by its cause:
///   what the user wrote, or a file or a machine that refuses   2  ConfigurationError, FileError, std::system_error
///   what the numbers did                                       3  NumericalFailure, EngineError, std::bad_alloc
///   a defect of this program                                  70  std::logic_error and all other types
/// Stopped and FirstRankFailed have their own.
ExitCode code_of(const std::exception_ptr& failure) noexcept;

/// Calls `read` and returns its result. What it refuses (std::invalid_argument), the user has written: it throws
/// ConfigurationError instead, with `place` in front of the message.
template <typename Read>
auto as_written_by_user(const std::string& place, Read&& read) {
  try {
    return std::forward<Read>(read)();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError((place.empty() ? "" : place + ": ") + error.what());
  }
}

/// Runs `body` and returns its result, or the code of what it throws; FinishedEarly -> 0. Instead of 0 and 4 it returns
/// 1 if standard output cannot be written. Prints one message "flowslide: ..." to stderr per failure. `rank` is the MPI
/// rank, if known: what every rank says alike (help, configuration) is printed by rank 0 only, a numerical failure or a
/// defect by each rank that meets it. Never throws.
int run_main(const std::function<int()>& body, int rank = 0) noexcept;

}  // namespace flowslide
