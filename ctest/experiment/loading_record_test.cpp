// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/loading_record.hpp"

#include <gtest/gtest.h>

#include "support/stress_table.hpp"

namespace flowslide {
namespace {

TEST(LoadingRecord, GoesIntoAResultAndBack) {
  const StressTable table{{0.0, 0.5}, {-1.0, 1.0 / 3.0}};
  const InputTable kept = input_table("quake.txt", table);
  EXPECT_EQ(kept.name, "loading");
  EXPECT_EQ(kept.file, "quake.txt");
  EXPECT_EQ(kept.rows.axis.units, "s");
  EXPECT_EQ(kept.rows.column("stress_change").units, "Pa");
  EXPECT_EQ(stress_table(kept).time, table.time);
  EXPECT_EQ(stress_table(kept).change, table.change);
}

}  // namespace
}  // namespace flowslide
