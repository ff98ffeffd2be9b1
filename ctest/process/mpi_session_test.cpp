// SPDX-License-Identifier: GPL-2.0-or-later
// Run in one process, and again on two MPI ranks (process.two_ranks).
#include "process/mpi_session.hpp"

#include <gtest/gtest.h>
#include <mpi.h>

#include <array>

namespace flowslide {
namespace {

TEST(MpiSessionRanks, KnowTheirPlace) {
  EXPECT_GE(mpi_rank(), 0);
  EXPECT_LT(mpi_rank(), mpi_ranks());
}

TEST(MpiSessionRanks, HaveACommunicator) {
  ASSERT_EQ(all_ranks() == nullptr, mpi_ranks() == 1);
  if (all_ranks() == nullptr) return;
  EXPECT_EQ(*static_cast<const MPI_Comm*>(all_ranks()), MPI_COMM_WORLD);
}

TEST(MpiSessionRanks, ShareTheirValues) {
  EXPECT_EQ(value_of_first_rank(7 + mpi_rank()), 7);
  std::array<double, 2> largest{static_cast<double>(mpi_rank()), -static_cast<double>(mpi_rank())};
  largest_over_ranks(largest);
  EXPECT_EQ(largest[0], mpi_ranks() - 1);
  EXPECT_EQ(largest[1], 0.0);
  EXPECT_EQ(smallest_at_end({5 - mpi_rank(), 0, {}}), 5 - (mpi_ranks() - 1));
}

TEST(MpiSession, MayBeAskedForAgain) {
  ensure_mpi();
  ensure_mpi();
  int initialized = 0;
  MPI_Initialized(&initialized);
  EXPECT_EQ(initialized, 1);
}

}  // namespace
}  // namespace flowslide
