// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_loading_table.hpp"

#include <sys/stat.h>

#include "configuration/error.hpp"
#include "support/comma_locale.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class LoadingTable : public testing::Test {
 protected:
  StressTable read(const std::string& text) const { return read_loading_table(folder_.write("loading.txt", text)); }
  std::string complaint(const std::string& text) const {
    return message_of<ConfigurationError>([&] { read(text); });
  }
  ScratchFolder folder_;
};

TEST_F(LoadingTable, HasTwoColumnsCommentsAndBlankLines) {
  const StressTable table = read("# time  stress\n\n0 0\n  0.5\t1.2e3  # the quake\n2 -300\n");
  EXPECT_EQ(table.time, (std::vector<double>{0.0, 0.5, 2.0}));
  EXPECT_EQ(table.change, (std::vector<double>{0.0, 1200.0, -300.0}));
}

TEST_F(LoadingTable, MayEndWithoutANewlineOrWithThoseOfWindows) {
  EXPECT_EQ(read("0 0\r\n1 5\r\n").change, (std::vector<double>{0.0, 5.0}));
  EXPECT_EQ(read("0 7").change, (std::vector<double>{7.0}));
}

TEST_F(LoadingTable, EmptyOneIsRefused) {
  EXPECT_CONTAINS(complaint(""), "loading.txt: the loading table is empty");
  EXPECT_CONTAINS(complaint("# nothing\n\n"), "give rows of a time in s and a stress in Pa");
}

TEST_F(LoadingTable, UnsortedOneIsRefused) {
  EXPECT_CONTAINS(complaint("0 0\n2 1\n1 2\n"), "loading.txt:3: the time 1 s does not come after 2 s; sort the rows");
  EXPECT_CONTAINS(complaint("0 0\n0 1\n"), "loading.txt:2: ");
}

TEST_F(LoadingTable, WhatIsNoFiniteNumberIsRefused) {
  EXPECT_CONTAINS(complaint("0 0\n1 nan\n"), "loading.txt:2: \"nan\" is not a finite number");
  EXPECT_CONTAINS(complaint("inf 0\n"), "loading.txt:1: \"inf\"");
  EXPECT_CONTAINS(complaint("0 3kPa\n"), "\"3kPa\" is not a finite number; give a time in s and a stress in Pa");
  EXPECT_CONTAINS(complaint("0 1e999\n"), "\"1e999\"");
  EXPECT_CONTAINS(complaint("time stress\n"), "\"time\"");
}

TEST_F(LoadingTable, RowsOfOtherThanTwoNumbersAreRefused) {
  EXPECT_CONTAINS(complaint("0 0\n1\n"), "loading.txt:2: a row of a loading table is two numbers");
  EXPECT_CONTAINS(complaint("0 0 0\n"), "loading.txt:1: a row");
}

TEST_F(LoadingTable, FileThatCannotBeReadIsNamed) {
  for (const auto& path : {folder_.path() / "missing.txt", folder_.path()})
    EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_loading_table(path); }), path.string() + ": ");
}

TEST_F(LoadingTable, MayBeginWithAByteOrderMark) {
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "0 0\r\n0.5 1200\r\n")
                .time,
            (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(read("\xEF\xBB\xBF# time stress\n0 7\n").change, (std::vector<double>{7.0}));
}

TEST_F(LoadingTable, PipeIsRefusedInsteadOfWaitedFor) {
  const auto pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_loading_table(pipe); }),
                  "pipe: is a pipe, a socket or a device, but a loading table is needed; write it to a file first");
}

TEST_F(LoadingTable, HasADecimalPointInEveryLocale) {
  const CommaLocale host;
  const StressTable table = read("0 0\n0.05 1.2e3\n+2.5 -0.5\n");
  EXPECT_EQ(table.time, (std::vector<double>{0.0, 0.05, 2.5}));
  EXPECT_EQ(table.change, (std::vector<double>{0.0, 1200.0, -0.5}));
  EXPECT_CONTAINS(complaint("0 0\n0,05 1200\n"), "loading.txt:2: \"0,05\" is not a finite number");
  EXPECT_CONTAINS(complaint("0.5 0\n0.25 1\n"), "the time 0.25 s does not come after 0.5 s");
}

TEST_F(LoadingTable, TakesNoHexadecimalNumberForADecimalOne) {
  EXPECT_CONTAINS(complaint("0x10 0\n"), "\"0x10\" is not a finite number");
  EXPECT_CONTAINS(complaint("0 +-5\n"), "\"+-5\" is not a finite number");
}

}  // namespace
}  // namespace flowslide
