// SPDX-License-Identifier: GPL-2.0-or-later
// The session of a build without MPI: process/one_process.cpp.
#include <gtest/gtest.h>

#include <array>

#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

TEST(OneProcess, IsTheFirstAndOnlyRank) {
  ensure_mpi();
  EXPECT_EQ(mpi_rank(), 0);
  EXPECT_EQ(mpi_ranks(), 1);
  EXPECT_EQ(all_ranks(), nullptr);
}

TEST(OneProcess, KeepsItsValues) {
  EXPECT_EQ(value_of_first_rank(7), 7);
  std::array<double, 2> values{3.0, -1.0};
  largest_over_ranks(values);
  EXPECT_EQ(values, (std::array{3.0, -1.0}));
  EXPECT_EQ(smallest_at_end({5, 0, {}}), 5);
}

}  // namespace
}  // namespace flowslide
