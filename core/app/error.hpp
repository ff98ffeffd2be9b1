// SPDX-License-Identifier: GPL-2.0-or-later
// What a program of this project can end with: one exit code and at most one message per failure.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

namespace flowslide {

/// What a program returns to the shell. These numbers are part of the interface: scripts and schedulers read them.
enum class ExitCode : int {
  ok = 0,                 ///< all that was asked for is done
  configuration = 2,      ///< bad option, bad configuration file, or an output that cannot be written
  numerical_failure = 3,  ///< the run was stopped with a diagnosis: no result of it may be used
  claim_not_met = 4,      ///< the run is good, but a claim of the paper does not hold in it
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

/// Runs `body` and returns its result, or the exit code that belongs to the exception it ended with:
/// ConfigurationError, FileError of record, std::filesystem::filesystem_error, std::invalid_argument, std::domain_error
/// -> 2, everything else (std::runtime_error of an engine, std::bad_alloc, unknown types) -> 3, FinishedEarly -> 0,
/// Stopped -> its own.
/// Prints exactly one message "flowslide: ..." to stderr per failure. `rank` is the MPI rank, if known: what every rank
/// says alike (help, configuration) is printed by rank 0 only, a numerical failure by each rank that meets it.
/// Never throws.
int run_main(const std::function<int()>& body, int rank = 0) noexcept;

}  // namespace flowslide
