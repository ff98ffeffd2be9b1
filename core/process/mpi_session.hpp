// SPDX-License-Identifier: GPL-2.0-or-later
// MPI, started at first use and ended with the process.
#pragma once
#include <mpi.h>

namespace flowslide {

/// Starts MPI unless it is started already. If it was started here, it ends with the process. Safe to call again.
void ensure_mpi();
/// A communicator of all ranks for their agreement at the end of the program. It is separate from MPI_COMM_WORLD, where
/// a failed rank may leave messages unanswered. MPI_COMM_NULL if the caller has started MPI, because the caller also
/// ends it, and if there is one process without a launcher.
MPI_Comm communicator_at_end();
int mpi_rank();   ///< rank of this process, 0 without a launcher
int mpi_ranks();  ///< number of ranks, 1 without a launcher

}  // namespace flowslide
