// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

const Configuration& sample() {
  static const Configuration c = Configuration::from_text(R"(stress = "3 kPa"
friction = "50 %"
layers = 20
rolling = false
engine = "native"
rates = ["1e-4 1/s", "2 1/s"]
lattice = [20, 20, 22]
empty = []
names = ["a", "b"]
date = 2020-01-02
nested = [[1, 2]]
one = 5
[table]
)",
                                                          "case.toml");
  return c;
}

template <typename Call>
std::string complaint(Call&& call) {
  return message_of<ConfigurationError>(std::forward<Call>(call));
}

TEST(ConfigurationValues, AreReadByType) {
  EXPECT_EQ(sample().quantity("stress", dimension::stress), 3000.0);
  EXPECT_EQ(sample().number("friction", Range::between(0, 1)), 0.5);
  EXPECT_EQ(sample().integer("layers", Range::at_least(3)), 20);
  EXPECT_FALSE(sample().flag("rolling"));
  EXPECT_EQ(sample().text("engine", {"native", "liggghts"}), "native");
}

TEST(ConfigurationValues, AreReadAsLists) {
  EXPECT_EQ(sample().quantities("rates", dimension::rate), (std::vector<double>{1e-4, 2.0}));
  EXPECT_EQ(sample().integers("lattice"), (std::vector<std::int64_t>{20, 20, 22}));
  EXPECT_EQ(sample().texts("names"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(sample().numbers("lattice").size(), 3U);
}

TEST(ConfigurationValues, TakeASingleValueAsAListOfOne) {
  EXPECT_EQ(sample().numbers("one"), std::vector<double>{5.0});
  EXPECT_EQ(sample().quantities("stress", dimension::stress), std::vector<double>{3000.0});
}

TEST(ConfigurationValues, PointAtTheItemThatIsWrong) {
  EXPECT_CONTAINS(complaint([] { sample().quantities("rates", dimension::rate, Range::below(1)); }),
                  "case.toml:6:22: rates = \"2 1/s\" is not allowed: it must be below 1 1/s");
  EXPECT_CONTAINS(complaint([] { sample().integers("lattice", Range::at_least(21)); }), "case.toml:7:12: ");
  EXPECT_CONTAINS(complaint([] { sample().texts("names", {"b", "c"}); }), "case.toml:9:10: names = \"a\"");
}

TEST(ConfigurationValues, PointAtTheItemThatHasNoUnit) {
  EXPECT_EQ(complaint([] { sample().quantities("lattice", dimension::rate); }),
            "case.toml:7:12: lattice = 20 has no unit: it would be 20 1/s; write \"20 1/s\"");
}

TEST(ConfigurationValues, RefuseAnEmptyList) {
  EXPECT_CONTAINS(complaint([] { sample().numbers("empty"); }), "case.toml:8:9: empty = [] is empty");
}

TEST(ConfigurationValues, RefuseListsTablesAndDatesInPlaceOfAValue) {
  EXPECT_CONTAINS(complaint([] { sample().integer("lattice"); }), "lattice = [20, 20, 22] is a list, but one value");
  EXPECT_CONTAINS(complaint([] { sample().integer("table"); }), "case.toml:13:2: table is a table");
  EXPECT_CONTAINS(complaint([] { sample().numbers("table"); }), "table is a table, but a list is needed");
  EXPECT_CONTAINS(complaint([] { sample().text("date"); }), "date = 2020-01-02 is a date");
  EXPECT_CONTAINS(complaint([] { sample().numbers("nested"); }), "nested = [1, 2] is a date, a list or a table");
}

TEST(ConfigurationValues, AreChosenByTheirNames) {
  const auto choose = [](const std::string& name) {
    return sample().choice<int>("engine", {{"liggghts", 1}, {name, 2}});
  };
  EXPECT_EQ(choose("native"), 2);
  EXPECT_CONTAINS(complaint([&] { choose("mixed"); }), "it must be \"liggghts\" or \"mixed\"");
}

TEST(ConfigurationValues, PathsStandBesideTheFileThatNamesThem) {
  const ScratchFolder folder;
  const auto file = folder.write("case.toml", "file = \"a.txt\"\nabsolute = \"/b/c.txt\"\n");
  EXPECT_EQ(Configuration(Layers{file, "", {}, {}}).path("file"), folder.path() / "a.txt");
  EXPECT_EQ(Configuration(Layers{file, "", {}, {}}).path("absolute"), "/b/c.txt");
  EXPECT_EQ(Configuration(Layers{file, "", {}, {{"file", "a.txt", "--set file=a.txt"}}}).path("file"), "a.txt");
  EXPECT_EQ(Configuration::from_text("file = \"a.txt\"", "case.toml").path("file"), "a.txt");
}

TEST(ConfigurationValues, RefuseAMissingKeyWithEachGetter) {
  EXPECT_CONTAINS(complaint([] { sample().quantity("x", dimension::time, Range::positive()); }), "a time, above 0 s");
  EXPECT_CONTAINS(complaint([] { sample().integer("x", Range::at_least(3)); }), "an integer, at least 3");
  EXPECT_CONTAINS(complaint([] { sample().flag("x"); }), "true or false");
  EXPECT_CONTAINS(complaint([] { sample().text("x", {"p", "q"}); }), "\"p\" or \"q\"");
  EXPECT_CONTAINS(complaint([] { sample().texts("x"); }), "each a text");
}

}  // namespace
}  // namespace flowslide
