// SPDX-License-Identifier: GPL-2.0-or-later
// MPI, started when it is first needed and ended with the process.
#pragma once
#include <mpi.h>

namespace flowslide {

/// Starts MPI at first use and ends it with the process, unless the caller has done so. Safe to call again.
void ensure_mpi();
/// All ranks, for what they agree on at their end, apart from messages that a rank which failed has left unanswered.
/// MPI_COMM_NULL where the caller has started MPI: its end is the caller's.
MPI_Comm communicator_at_end();
int mpi_rank();
int mpi_ranks();

}  // namespace flowslide
