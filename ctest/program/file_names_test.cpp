// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/file_names.hpp"

#include "configuration/error.hpp"
#include "program/case.hpp"
#include "support/messages.hpp"

namespace flowslide::file_names_test {
namespace {

Point point(const std::string& name, std::vector<std::string> tables = {}) {
  return {.name = name, .figures = {}, .description = "a slide", .tables = std::move(tables)};
}

std::string complaint(const std::vector<Point>& points, const std::vector<std::string>& tables) {
  return message_of<ConfigurationError>([&] { refuse_names_that_meet(points, tables); });
}

TEST(FileNames, AreAllDifferent) {
  EXPECT_NO_THROW(refuse_names_that_meet({point("RD"), point("RD_r2"), point("RI", {"RI_profiles"})},
                                         {"sweep", "RD_over_time", "RI_profiles_band"}));
}

TEST(FileNames, RefuseAPointAndAReplicateOfAnother) {
  const std::string message = complaint({point("RD_ramp"), point("RD_ramp_r2"), point("RD_ramp_r2")}, {});
  EXPECT_CONTAINS(message, "the name \"RD_ramp_r2\" is taken twice");
  EXPECT_CONTAINS(message, "replicate N of a run is named <name>_rN");
}

TEST(FileNames, RefuseAPointAndATable) {
  EXPECT_CONTAINS(complaint({point("sweep")}, {"sweep"}), "by a table of the figures and by a run");
  EXPECT_CONTAINS(complaint({point("RD"), point("RD_over_time")}, {"RD_over_time"}), "\"RD_over_time\"");
  EXPECT_CONTAINS(complaint({point("RD", {"RD_profiles"}), point("RD_profiles")}, {}), "a table of the run RD");
  EXPECT_CONTAINS(complaint({point("claims")}, {}), "by the program");
}

}  // namespace
}  // namespace flowslide::file_names_test
