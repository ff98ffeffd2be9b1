// SPDX-License-Identifier: GPL-2.0-or-later
// The exit codes of a program, and exceptions that end it without an error in configuration, files or numbers.
#pragma once
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

namespace flowslide {

/// The exit code of a program. These numbers are part of the interface: scripts and schedulers read them.
enum class ExitCode : int {
  ok = 0,                 ///< all requested work is done
  output = 1,             ///< standard output could not be written and is incomplete
  configuration = 2,      ///< bad option, bad configuration file, or an output that cannot be written
  numerical_failure = 3,  ///< the run was stopped with a diagnosis; its results must not be used
  claim_not_met = 4,      ///< the run is valid, but a claim of the paper does not hold in it
  defect = 70,            ///< an internal error of the program; please report it
  resumable = 75,         ///< stopped in time; a later call continues from the checkpoint
  interrupted = 130       ///< ended by the user
};

/// The number that `main` returns.
constexpr int to_int(ExitCode code) { return static_cast<int>(code); }

/// Not an error: the program only prints a text (help, version). `run_main` prints it to stdout and returns 0.
class FinishedEarly : public std::exception {
 public:
  explicit FinishedEarly(std::string text) : text_(std::move(text)) {}
  const char* what() const noexcept override { return text_.c_str(); }

 private:
  std::string text_;
};

/// A run was stopped before its end. The message says what a later call continues from.
class Stopped : public std::runtime_error {
 public:
  Stopped(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Existing files prevent the request: those of another run, or a folder that cannot be used. The message gives the
/// finding and the remedy.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The first MPI rank has failed and reports the reason. The program returns its exit code: see same_exit_code.
class FirstRankFailed : public std::exception {
 public:
  const char* what() const noexcept override { return "the first rank failed"; }
};

}  // namespace flowslide
