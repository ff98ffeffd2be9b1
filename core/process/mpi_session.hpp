// SPDX-License-Identifier: GPL-2.0-or-later
// The MPI ranks of a program. A build without LIGGGHTS has no MPI: its program is one process (one_process.cpp).
#pragma once
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace flowslide {

/// Starts MPI unless it is started already. If it was started here, it ends with the process. Safe to call again. Does
/// nothing without MPI.
void ensure_mpi();
int mpi_rank();   ///< rank of this process, 0 without a launcher
int mpi_ranks();  ///< number of ranks, 1 without a launcher

/// Points to the MPI_Comm of all ranks, for make_engine; starts MPI if there may be several. nullptr if this process is
/// alone.
const void* all_ranks();

/// Returns the value of the first rank on all ranks. Collective.
int value_of_first_rank(int value);

/// Replaces each value by its largest over the ranks. Collective.
void largest_over_ranks(std::span<double> values);

/// The agreement at the end of a program.
struct AtEnd {
  std::int64_t value = 0;                         ///< of this rank
  int code = 0;                                   ///< exit code of this rank
  std::optional<std::chrono::seconds> longest_wait;  ///< empty: waits for the others without limit
  std::function<void()> before_abort = [] {};     ///< called before all ranks are ended
};
/// The smallest value over the ranks. Collective, the last call of a program. If the others do not answer within
/// `longest_wait`, ends all ranks with `code`. Uses a communicator of its own, because a failed rank may leave messages
/// unanswered elsewhere. Returns the value of this rank if the caller has started MPI, because the caller then ends it.
std::int64_t smallest_at_end(const AtEnd& mine);

}  // namespace flowslide
