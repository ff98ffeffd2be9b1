// SPDX-License-Identifier: GPL-2.0-or-later
// The exit codes of a program, and the ends of it that are no failure of configuration, files or numbers.
#pragma once
#include <exception>
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

/// What was asked for cannot be done with what is there: another run's files, a folder that cannot be used. The message
/// says what is there and how to mend it.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The first MPI rank has failed, and says why. Its exit code counts: see same_exit_code.
class FirstRankFailed : public std::exception {
 public:
  const char* what() const noexcept override { return "the first rank failed"; }
};

}  // namespace flowslide
