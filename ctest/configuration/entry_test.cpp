// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/entry.hpp"

#include <algorithm>

#include "configuration/entry_reader.hpp"
#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

std::string keys_of(const std::vector<Entry>& entries) {
  std::string keys;
  for (const Entry& entry : entries) keys += entry.key + " ";
  return keys;
}

const Entry& at(const std::vector<Entry>& entries, const std::string& key) {
  return *std::find_if(entries.begin(), entries.end(), [&](const Entry& entry) { return entry.key == key; });
}

TEST(Place, ShowsLineAndColumnWhereThereAreAny) {
  EXPECT_EQ((Place{"case.toml", 3, 7}.text()), "case.toml:3:7");
  EXPECT_EQ((Place{"--set a=1", 0, 0}.text()), "--set a=1");
}

TEST(KeyOrder, SortsPositionsByNumber) {
  std::vector<std::string> keys{"p.10.a", "p.2.b", "p.2.a", "p", "o.z", "p.x", "p.1"};
  std::sort(keys.begin(), keys.end(), KeyOrder());
  EXPECT_EQ(keys, (std::vector<std::string>{"o.z", "p", "p.1", "p.2.a", "p.2.b", "p.10.a", "p.x"}));
}

TEST(KeyOrder, TellsPositionsWithLeadingZerosApart) {
  const KeyOrder before;
  EXPECT_TRUE(before("p.01", "p.1") != before("p.1", "p.01"));
}

TEST(StandsBelow, NeedsAWholePart) {
  EXPECT_TRUE(stands_below("a.b", "a"));
  EXPECT_FALSE(stands_below("ab.c", "a"));
  EXPECT_FALSE(stands_below("a", "a"));
}

TEST(Overlay, ReplacesValuesAndKeepsTheirNewPlace) {
  auto base = read_entries("[s]\na = 1\nb = 2\n", "base");
  overlay(base, read_entries("[s]\n\nb = 3\nc = 4\n", "user"));
  EXPECT_EQ(keys_of(base), "s s.a s.b s.c ");
  EXPECT_EQ(at(base, "s.b").whole.written, "3");
  EXPECT_EQ(at(base, "s.b").whole.place.text(), "user:3:5");
  EXPECT_EQ(at(base, "s.a").whole.place.text(), "base:2:5");
}

TEST(Overlay, ReplacesAListOfTablesAsAWhole) {
  auto base = read_entries("[[p]]\na = 1\n[[p]]\na = 2\n", "base");
  overlay(base, read_entries("[[p]]\nb = 3\n", "user"));
  EXPECT_EQ(keys_of(base), "p p.0 p.0.b ");
}

TEST(Overlay, ReachesIntoAListOfTables) {
  auto base = read_entries("[[p]]\na = 1\n[[p]]\na = 2\n", "base");
  overlay(base, read_option("p.1.a", "5", "--set p.1.a=5"));
  EXPECT_EQ(at(base, "p.1.a").whole.written, "5");
  EXPECT_EQ(at(base, "p.0.a").whole.written, "1");
}

TEST(Overlay, RefusesATableInPlaceOfAValue) {
  auto base = read_entries("a = 1\n[t]\nb = 2\n", "base");
  EXPECT_EQ(message_of<ConfigurationError>([&] { overlay(base, read_entries("[a]\nx = 1\n", "user")); }),
            "user:1:2: the table [a] would replace the value 1 of base:1:5; give a value instead");
  EXPECT_EQ(message_of<ConfigurationError>([&] { overlay(base, read_option("t", "7", "--set t=7")); }),
            "--set t=7: t = 7 would replace the table [t] of base:2:2; set one of its keys instead");
}

TEST(TakeBelow, MovesASubtreeOut) {
  auto entries = read_entries("a = 1\n[scale.quick]\nb.c = 2\n[scale.paper]\nb.c = 3\n", "base");
  const auto taken = take_below(entries, "scale.quick");
  EXPECT_EQ(keys_of(taken), "b b.c ");
  EXPECT_EQ(keys_of(entries), "a scale scale.paper scale.paper.b scale.paper.b.c ");
}

}  // namespace
}  // namespace flowslide
