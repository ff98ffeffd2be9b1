// SPDX-License-Identifier: GPL-2.0-or-later
// What a program of this project can end with: one exit code and at most one message per failure.
#pragma once
#include <exception>
#include <functional>

#include "process/exit_code.hpp"

namespace flowslide {

/// The exit code of a failure, by its cause:
///   what the user wrote, or a file or a machine that refuses   2  ConfigurationError, Refused, FileError,
///                                                                 std::system_error
///   what the numbers did                                       3  NumericalFailure, EngineError, std::bad_alloc
///   a defect of this program                                  70  std::logic_error and all other types
/// Stopped has its own. FirstRankFailed counts as a defect: same_exit_code replaces it by the code of the first rank.
ExitCode code_of(const std::exception_ptr& failure) noexcept;

/// Runs `body` and returns its result, or the code of what it throws; FinishedEarly -> 0. Instead of 0 and 4 it returns
/// 1 if standard output cannot be written. Prints one message "flowslide: ..." to stderr per failure. `rank` is the MPI
/// rank, if known: what every rank says alike (help, configuration) is printed by rank 0 only, a numerical failure or a
/// defect by each rank that meets it. Never throws.
int run_main(const std::function<int()>& body, int rank = 0) noexcept;

}  // namespace flowslide
