// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/input_table.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flowslide {
namespace {

InputTable table(const std::vector<double>& time, const std::vector<double>& stress) {
  InputTable table{"loading", "quake.txt", {}};
  table.rows.axis.values = time;
  table.rows.columns = {{"stress_change", "Delta tau_d", "Pa", "change of the driving shear stress", "", stress}};
  return table;
}

TEST(InputTable, ContentIsThatOfTheNumbersAlone) {
  InputTable same = table({0.0, 1.0}, {0.0, 500.0});
  same.file = "elsewhere.txt";
  EXPECT_EQ(content_of(same), content_of(table({0.0, 1.0}, {0.0, 500.0})));
  EXPECT_EQ(content_of(same).substr(0, 13), "2 rows (hash ");
}

TEST(InputTable, ContentChangesWithTheSmallestChangeOfANumber) {
  const std::string content = content_of(table({0.0, 1.0}, {0.0, 500.0}));
  EXPECT_NE(content_of(table({0.0, 1.0}, {0.0, std::nextafter(500.0, 0.0)})), content);
  EXPECT_NE(content_of(table({0.0, std::nextafter(1.0, 0.0)}, {0.0, 500.0})), content);
  EXPECT_NE(content_of(table({0.0, 1.0, 2.0}, {0.0, 500.0, 500.0})), content);
  EXPECT_NE(content_of(table({0.0, 500.0}, {0.0, 1.0})), content);
}

}  // namespace
}  // namespace flowslide
