// SPDX-License-Identifier: GPL-2.0-or-later
// Run in one process, and again on two MPI ranks (process.two_ranks).
#include "process/mpi_session.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(MpiSessionRanks, KnowTheirPlace) {
  EXPECT_GE(mpi_rank(), 0);
  EXPECT_LT(mpi_rank(), mpi_ranks());
}

TEST(MpiSession, MayBeAskedForAgain) {
  ensure_mpi();
  ensure_mpi();
  int initialized = 0;
  MPI_Initialized(&initialized);
  EXPECT_EQ(initialized, 1);
  EXPECT_NE(communicator_at_end(), MPI_COMM_NULL);
}

}  // namespace
}  // namespace flowslide
