// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/nesting.hpp"

#include <gtest/gtest.h>

#include <string>

namespace flowslide::nesting_test {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(Nesting, BearsWhatIsAllowed) {
  EXPECT_FALSE(too_deep_at(""));
  EXPECT_FALSE(too_deep_at(repeated("a.", most_nesting - 1) + "a = 1.5\n"));
  EXPECT_FALSE(too_deep_at("[" + repeated("a.", most_nesting - 1) + "a]\n"));
  EXPECT_FALSE(too_deep_at("a = " + repeated("[", most_nesting) + repeated("]", most_nesting)));
  EXPECT_FALSE(too_deep_at(repeated("a.b = [1.5, 2.5]\n[[c.d]]\ne = { f.g = 1 }\n", 100)));
}

TEST(Nesting, FindsWhereItIsTooDeep) {
  EXPECT_EQ(too_deep_at(repeated("a.", most_nesting) + "a = 1\n"), 2U * most_nesting - 1U);
  EXPECT_EQ(too_deep_at("[" + repeated("a . ", most_nesting) + "a]\n"), 4U * most_nesting - 1U);
  EXPECT_EQ(too_deep_at("x = " + repeated("[", most_nesting + 1)), 4U + most_nesting);
  EXPECT_TRUE(too_deep_at(repeated("a={", most_nesting + 1)));
  EXPECT_TRUE(too_deep_at("a = {" + repeated("b.", most_nesting) + "b = 1}"));
  EXPECT_TRUE(too_deep_at("x = [1, {" + repeated("'b'.", most_nesting) + "b = 1}]"));
}

TEST(Nesting, DoesNotCountInStringsAndComments) {
  const std::string brackets = repeated("[", 100), dots = repeated("a.", 100);
  EXPECT_FALSE(too_deep_at("# " + brackets + dots));
  EXPECT_FALSE(too_deep_at("a = \"" + brackets + dots + "\\\"" + brackets + "\" # '\n"));
  EXPECT_FALSE(too_deep_at("a = '" + brackets + dots + "\\'\n"));
  EXPECT_FALSE(too_deep_at("a = \"\"\"\n" + brackets + "\n\"" + dots + "\\\"\"\"\"\n"));
  EXPECT_FALSE(too_deep_at("a = '''\n" + brackets + "\n''" + dots + "'''\n"));
}

TEST(Nesting, CountsBehindEveryString) {
  const std::string deep = repeated("[", 100);
  for (const char* text : {"\"a\"", "\"a\\\"\"", "\"\\\\\"", "'a\\'", "\"\"\"a\"\"\"", "\"\"\"a\"\"\"\"\"", "'''a''''",
                           "'''a'''''", "\"\"", "''", "\"\"\"\"\"\"", "''''''", "\"\"\"\n\\\"\"\"\""})
    EXPECT_TRUE(too_deep_at(std::string("a = ") + text + "\nb = " + deep)) << text;
}

TEST(Nesting, EndsWhereAStringIsNotClosed) {  // the reader refuses such a text there
  EXPECT_FALSE(too_deep_at("a = \"b\nc = " + repeated("[", 100)));
  EXPECT_FALSE(too_deep_at("a = '''b\n" + repeated("[", 100)));
  EXPECT_FALSE(too_deep_at("a = \"\\"));
}

}  // namespace
}  // namespace flowslide::nesting_test
