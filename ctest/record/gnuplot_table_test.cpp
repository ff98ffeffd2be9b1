// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/gnuplot_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "damage.hpp"
#include "example.hpp"
#include "same_bits.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(GnuplotTable, EqualsTheResultFileBitForBit) {
  const TemporaryFolder folder;
  write_result(folder / "run.h5", example_result());
  const auto result = read_result(folder / "run.h5");
  write_table(folder / "run.dat", table_of(result));
  expect_same_bits(read_table(folder / "run.dat").series, result.series);
  expect_same_bits(result.series, example_result().series);
}

TEST(GnuplotTable, SaysWhereItComesFrom) {
  const TemporaryFolder folder;
  const auto result = example_result();
  write_table(folder / "run.dat", table_of(result));
  const auto text = read_file(folder / "run.dat");
  EXPECT_TRUE(
      text.starts_with("time shear_stress normal_stress inertial_number\n# case: fig03_undrained\n# point: e0=0.790\n"))
      << text.substr(0, 200);
  EXPECT_NE(text.find("# configuration: abc123\n"), std::string::npos);
  EXPECT_NE(text.find("# revision: " + result.provenance.git_revision), std::string::npos);
  EXPECT_NE(text.find("# column 1: time | t | s | time | \n"), std::string::npos);
  EXPECT_NE(text.find("# column 3: normal_stress | sigma | Pa | normal stress | compression positive\n"),
            std::string::npos);
  EXPECT_EQ(read_table(folder / "run.dat").header, table_of(result).header);
}

TEST(GnuplotTable, KeepsHeadersOnOneLine) {
  const TemporaryFolder folder;
  Table table{{{"case", "two\nlines"}}, example_series(2)};
  table.series.columns[0].long_name = "a|b\nc";
  write_table(folder / "run.dat", table);
  const auto read = read_table(folder / "run.dat");
  EXPECT_EQ(read.header.front().second, "two lines");
  EXPECT_EQ(read.series.columns[0].long_name, "a b c");
}

TEST(GnuplotTable, NamesColumnsOfTextToo) {
  EXPECT_EQ(
      table_head({{"slide", "", "text", "its name", "", {}}, {"time", "t", "s", "time", "", {}}}, {{"case", "a"}}),
      "slide time\n# case: a\n# column 1: slide |  | text | its name | \n# column 2: time | t | s | time | \n");
  for (const char* name : {"", "two words", "1st", "v,x"})
    EXPECT_THROW(table_head({{name, "", "1", "", "", {}}}), std::invalid_argument) << name;
}

TEST(GnuplotTable, WritesTheFewestDigits) {
  EXPECT_EQ(shortest(0.1), "0.1");
  EXPECT_EQ(shortest(-0.0), "-0");
  EXPECT_EQ(shortest(1e-7), "1e-07");
  EXPECT_EQ(shortest(0.1 + 0.2), "0.30000000000000004");
  EXPECT_EQ(shortest(28340.0), "28340");
}

TEST(GnuplotTable, RefusesNumbersThatAreNone) {
  const TemporaryFolder folder;
  Table table{{}, example_series()};
  table.series.columns[0].values[0] = std::nan("");
  EXPECT_THROW(write_table(folder / "run.dat", table), std::invalid_argument);
  EXPECT_EQ(folder.entries(), 0);
}

TEST(GnuplotTable, NamesTheLineOfADamage) {
  const TemporaryFolder folder;
  const std::string head = "# case: a\n# column 1: time | t | s | time | \n# column 2: x | x | m | x | \n0 1\n";
  const std::string good = "time x\n" + head;
  overwrite(folder / "run.dat", good);
  EXPECT_EQ(read_table(folder / "run.dat").series.column("x").values, std::vector{1.0});
  for (const char* bad : {"1\n", "1 2 3\n", "1 x\n", "1 nan\n", "1 2", "\n", "1 2x\n", "#\n"}) {
    overwrite(folder / "run.dat", good + bad);
    try {
      read_table(folder / "run.dat");
      ADD_FAILURE() << bad;
    } catch (const CorruptFileError& error) {
      EXPECT_NE(std::string(error.what()).find("run.dat:"), std::string::npos) << error.what();
    }
  }
  for (const std::string& bad : {head, "time y\n" + head, "time\n" + head, "\n" + head, std::string()}) {
    overwrite(folder / "run.dat", bad);
    EXPECT_THROW(read_table(folder / "run.dat"), CorruptFileError) << bad;
  }
  EXPECT_THROW(read_table(folder / "none.dat"), FileError);
}

}  // namespace
}  // namespace flowslide
