// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/run_list.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

std::string rows_of(const std::string& table) { return table.substr(table.find("\n", table.rfind("# column")) + 1); }

TEST(RunList, HasOneRowPerRun) {
  Point first{.name = "RD", .figures = {}, .description = "a slide"}, second = first, scene = first;
  first.curve = second.curve = "RD";
  first.grains = second.grains = 1100;
  second.name = "RD_r2";
  scene.name = "angle";
  const std::string table = run_list({first, second, scene}, "quick");
  EXPECT_TRUE(table.starts_with("run curve scale grains\n")) << table;
  EXPECT_EQ(rows_of(table), "RD RD quick 1100\nRD_r2 RD quick 1100\nangle angle quick 0\n");
}

TEST(RunList, HasNoRowWithoutRuns) { EXPECT_EQ(rows_of(run_list({}, "paper")), ""); }

}  // namespace
}  // namespace flowslide
