// SPDX-License-Identifier: GPL-2.0-or-later
// How a program of this project ends: with one exit code, and at most one message per failure.
#pragma once
#include <exception>
#include <functional>
#include <string>

#include "process/exit_code.hpp"

namespace flowslide {

/// The exit code of a failure, by its type:
///   2   input, file or machine: ConfigurationError, Refused, FileError, std::system_error
///   3   computation: NumericalFailure, EngineError, std::bad_alloc
///   70  defect of this program: std::logic_error and all other types
/// Stopped has its own code. FirstRankFailed counts as a defect; same_exit_code replaces it by the code of the first
/// rank.
ExitCode code_of(const std::exception_ptr& failure) noexcept;

/// Runs `body` and returns its result. If `body` throws, returns the code of the failure; 0 for FinishedEarly. Replaces
/// 0 and 4 by 1 if standard output cannot be written. Prints one message "flowslide: ..." per failure to stderr. `rank`
/// is the MPI rank, if known. Each rank prints its own numerical failure or defect. Rank 0 alone prints the messages
/// that are usually equal on all ranks (help, configuration). Those of another rank go to `unsaid`, if given, for
/// same_exit_code. Never throws.
int run_main(const std::function<int()>& body, int rank = 0, std::string* unsaid = nullptr) noexcept;

}  // namespace flowslide
