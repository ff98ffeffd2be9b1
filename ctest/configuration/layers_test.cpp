// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/layers.hpp"

#include <fmt/format.h>

#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr const char* case_text = R"([sample]
layers = 20
confining_stress = "28.34 kPa"

[point.loosest]
void_ratio = 0.790
[point.densest]
void_ratio = 0.751

[scale.quick]
sample.layers = 10
[scale.paper]
sample.confining_stress = "30 kPa"
)";

class LayeredConfiguration : public testing::Test {
 protected:
  Configuration read(const std::string& scale = "", const std::string& user = "",
                     std::vector<Override> overrides = {}) const {
    Layers layers{scratch_.write("case.toml", case_text), scale, {}, std::move(overrides)};
    if (!user.empty()) layers.user_file = scratch_.write("user.toml", user);
    return Configuration(layers);
  }
  template <typename Call>
  std::string complaint(Call&& call) const {
    std::string message = message_of<ConfigurationError>(std::forward<Call>(call));
    for (const std::string folder = scratch_.path().string() + "/"; message.find(folder) != std::string::npos;)
      message.erase(message.find(folder), folder.size());
    return message;
  }
  ScratchFolder scratch_;
};

double stress_of(const Configuration& c) { return c.quantity("sample.confining_stress", dimension::stress); }

TEST_F(LayeredConfiguration, ReadsTheCaseFile) {
  EXPECT_EQ(read().integer("sample.layers"), 20);
  EXPECT_EQ(stress_of(read()), 28340.0);
}

TEST_F(LayeredConfiguration, LaysTheScaleOverTheRestOfTheFile) {
  EXPECT_EQ(read("quick").integer("sample.layers"), 10);
  EXPECT_EQ(stress_of(read("quick")), 28340.0);
  EXPECT_EQ(read("paper").integer("sample.layers"), 20);
  EXPECT_EQ(stress_of(read("paper")), 30000.0);
}

TEST_F(LayeredConfiguration, LaysTheUsersFileOverTheScale) {
  EXPECT_EQ(read("quick", "sample.layers = 12").integer("sample.layers"), 12);
  EXPECT_EQ(read("quick", "sample.layers = 12\n[scale.quick]\nsample.layers = 14").integer("sample.layers"), 14);
  EXPECT_EQ(read("paper", "sample.layers = 12\n[scale.quick]\nsample.layers = 14").integer("sample.layers"), 12);
}

TEST_F(LayeredConfiguration, LaysOptionsOverAll) {
  EXPECT_EQ(
      read("quick", "sample.layers = 12", {{"sample.layers", "16", "--set sample.layers=16"}}).integer("sample.layers"),
      16);
  EXPECT_EQ(stress_of(read("", "", {{"sample.confining_stress", "3 kPa", "--set"}})), 3000.0);
  EXPECT_EQ(stress_of(read("", "", {{"sample.confining_stress", "3kPa", "--set"}})), 3000.0);
  EXPECT_EQ(stress_of(read("", "", {{"sample.confining_stress", "\"3 kPa\"", "--set"}})), 3000.0);
  EXPECT_EQ(stress_of(read(
                "", "", {{"sample.confining_stress", "1 Pa", "--set"}, {"sample.confining_stress", "2 Pa", "--set"}})),
            2.0);
}

TEST_F(LayeredConfiguration, KeepsThePlaceOfEachLayer) {
  const auto range = Range::at_least(100);
  EXPECT_CONTAINS(complaint([&] { read().integer("sample.layers", range); }), "case.toml:2:10: ");
  EXPECT_CONTAINS(complaint([&] { read("quick").integer("sample.layers", range); }), "case.toml:11:17: ");
  EXPECT_CONTAINS(complaint([&] { read("quick", "\nsample.layers = 12").integer("sample.layers", range); }),
                  "user.toml:2:17: sample.layers = 12 is not allowed: it must be at least 100; ");
  EXPECT_CONTAINS(complaint([&] {
                    read("", "", {{"sample.layers", "16", "--set sample.layers=16"}}).integer("sample.layers", range);
                  }),
                  "--set sample.layers=16: the value is not allowed: it must be at least 100; ");
}

TEST_F(LayeredConfiguration, RefusesAnUnknownScale) {
  EXPECT_CONTAINS(complaint([&] { read("papr"); }), "no scale \"papr\" (there is \"quick\" or \"paper\")");
  EXPECT_CONTAINS(complaint([&] { read("quick", "[scale.qick]\nsample.layers = 3"); }),
                  "user.toml:1:8: there is no scale \"qick\"");
  EXPECT_CONTAINS(complaint([&] { read("quick", "scale.quick = 3"); }), "user.toml:1:7: scale.quick is a value");
}

TEST_F(LayeredConfiguration, NamesAMissingFile) {
  EXPECT_CONTAINS(complaint([] { Configuration({"/nowhere/case.toml", "", {}, {}}); }), "/nowhere/case.toml");
}

TEST_F(LayeredConfiguration, RefusesUnknownKeysWithPlaceAndNearest) {
  const auto check = [](const Configuration& c) {
    c.integer("sample.layers");
    stress_of(c);
    for (const std::string& point : c.subtables("point")) c.number("point." + point + ".void_ratio");
    c.reject_unknown();
  };
  EXPECT_NO_THROW(check(read("quick")));
  EXPECT_EQ(complaint([&] { check(read("quick", "[sample]\nlayer = 3")); }),
            "user.toml:2:1: unknown key \"sample.layer\"; did you mean \"sample.layers\"?");
  EXPECT_EQ(complaint([&] { check(read("quick", "[smaple]\nlayers = 3\nb = 1")); }),
            "user.toml:1:2: unknown table \"smaple\"; did you mean \"sample\"?");
  EXPECT_EQ(complaint([&] {
              check(read("", "", {{"sample.lyaers", "3", "--set sample.lyaers=3"}}));
            }),
            "--set sample.lyaers=3: unknown key \"sample.lyaers\"; did you mean \"sample.layers\"?");
  EXPECT_EQ(complaint([&] { check(read("quick", "x = 1\ny = 2")); }),
            "user.toml:1:1: unknown key \"x\"; no known name is similar; --dry-run prints all keys\n"
            "user.toml:2:1: unknown key \"y\"; no known name is similar; --dry-run prints all keys");
}

TEST_F(LayeredConfiguration, ChecksTheSpellingOfScalesThatWereNotChosen) {
  const auto check = [](const Configuration& c) {
    c.accept("sample");
    for (const std::string& point : c.subtables("point")) c.number("point." + point + ".void_ratio");
    c.reject_unknown();
  };
  EXPECT_NO_THROW(check(read("quick", "[scale.paper.point.other]\nvoid_ratio = 0.7")));
  EXPECT_EQ(complaint([&] { check(read("quick", "[scale.paper.point.other]\nvoid_ration = 0.7")); }),
            "user.toml:2:1: unknown key \"point.other.void_ration\"; did you mean \"point.loosest.void_ratio\"?");
  EXPECT_CONTAINS(complaint([&] { check(read("quick", "[scale.paper]\nsmaple.layers = 7")); }),
                  "user.toml:2:1: unknown table \"smaple\"");
}

TEST_F(LayeredConfiguration, RefusesTheChoiceOfAScaleByAKey) {
  EXPECT_EQ(complaint([&] { read("", "scale = 'paper'\n"); }),
            "user.toml:1:1: scale = 'paper' is a value, but [scale] holds one table per scale; choose the scale with "
            "--scale");
}

class ConfigurationOnABase : public LayeredConfiguration {
 protected:
  Configuration read_on(const std::string& base, const std::string& case_file, const std::string& scale = "") const {
    scratch_.write("paper.toml", base);
    return Configuration(
        Layers{scratch_.write("shear/case.toml", "base = '../paper.toml'\n" + case_file), scale, {}, {}});
  }
};

TEST_F(ConfigurationOnABase, LaysTheCaseFileAndItsScaleOverTheBaseAndItsScale) {
  const std::string base = "n = 1\nm = 1\n[scale.quick]\nn = 2\nm = 2\nk = 2\n[scale.paper]\nm = 3\n";
  const Configuration quick = read_on(base, "m = 4\n[scale.quick]\nk = 5\n", "quick");
  EXPECT_EQ(quick.integer("n"), 2);
  EXPECT_EQ(quick.integer("m"), 4);
  EXPECT_EQ(quick.integer("k"), 5);
  EXPECT_EQ(read_on(base, "", "paper").integer("m"), 3);
}

TEST_F(ConfigurationOnABase, LeavesKeysOfTheBaseToOtherCases) {
  const Configuration c = read_on("n = 1\n[other]\nk = 1\n[scale.quick]\nother.k = 2\n", "[own]\nk = 1\n");
  EXPECT_EQ(c.integer("n"), 1);
  EXPECT_EQ(complaint([&] { c.reject_unknown(); }),
            "shear/case.toml:2:2: unknown table \"own\"; no known name is similar; --dry-run prints all keys");
  EXPECT_EQ(c.resolved(), "n = 1\n");
}

TEST_F(ConfigurationOnABase, TellsTheBaseFromTheUsersTables) {
  const Configuration c = read_on("[sample.a]\nn = 1\n[sample.b]\nn = 1\n", "[sample.c]\nn = 1\n");
  EXPECT_TRUE(c.is_of_base("sample.a"));
  EXPECT_FALSE(c.is_of_base("sample.c"));
  EXPECT_FALSE(c.is_users_table("sample.a"));
  EXPECT_TRUE(c.is_published("sample.a"));
  EXPECT_TRUE(c.changes().empty());
}

TEST_F(ConfigurationOnABase, SaysWhichRunsUseAKeyThatThisCaseDoesNot) {
  const auto complaint_about = [&](const std::string& toml) {
    const Configuration c = read_on("[sample.a]\ndrag = 1\n[sample.b]\ndrag = 1\n", "").overlaid(toml, "user.toml");
    c.subtables("sample");
    c.integer("sample.a.drag");
    c.describe_users("stop.end_time", "slides");
    c.describe_users("point.*.stop.end_time", "slides");
    return complaint([&] { c.reject_unknown(); });
  };
  EXPECT_EQ(complaint_about("[stop]\nend_time = 3\n"),
            "user.toml:1:2: the table \"stop\" is known, but no run of this case uses it: it belongs to slides");
  EXPECT_EQ(complaint_about("point.mine.stop.end_time = 3\n"),
            "user.toml:1:1: the table \"point\" is known, but no run of this case uses it: it belongs to slides");
  EXPECT_EQ(complaint_about("sample.b.drag = 3\n"),
            "user.toml:1:10: the key \"sample.b.drag\" is known, but no run of this case uses it: it belongs to "
            "[sample.b], which needs a run with sample = \"b\"");
  EXPECT_CONTAINS(complaint_about("sample.b.darg = 3\n"), "unknown key \"sample.b.darg\"; did you mean");
  EXPECT_CONTAINS(complaint_about("[halt]\nend_time = 3\n"), "unknown table \"halt\"");
}

TEST_F(ConfigurationOnABase, RefusesAUsersValueThatHasNoEffectForAReason) {
  const Configuration c = read_on("a = 1\nb = 1\nt.c = 1\n", "").overlaid("a = 2\nb = 2\n[t]\nc = 2\n", "user.toml");
  c.accept("a", "it needs d");
  c.accept("b", "it needs d");
  c.accept("t");
  EXPECT_EQ(c.integer("b"), 2);
  EXPECT_EQ(complaint([&] { c.reject_unknown(); }), "user.toml:1:1: \"a\" has no effect: it needs d; remove it");
  const Configuration published = read_on("a = 1\n", "");
  published.accept("a", "it needs d");
  EXPECT_NO_THROW(published.reject_unknown());  // a default of the case
}

TEST_F(ConfigurationOnABase, NamesThePlaceOfTheUsersValuesBelowATable) {
  const Configuration c = read_on("[slope]\nangle = 1\ndepth = 1\n", "");
  EXPECT_CONTAINS(c.place_of({"slope"}), "paper.toml:1:2: [slope]");
  EXPECT_EQ(c.overlaid("slope.depth = 2\n", "user.toml").place_of({"slope"}), "user.toml:1:7: slope.depth = 2");
  EXPECT_EQ(c.users_table_of("slope.own"), "");
  EXPECT_EQ(c.overlaid("[point.mine]\na = 2\n", "user.toml").users_table_of("point.mine.stop"), "point.mine");
}

TEST_F(ConfigurationOnABase, NamesTheLayerOfEachValue) {
  scratch_.write("paper.toml", "a = 1\nb = 1\n");
  const auto case_file = scratch_.write("shear/case.toml", "base = '../paper.toml'\nb = 2\nc = [1]\n");
  const Configuration c(Layers{case_file, "", {}, {{"c", "[2]", "--set c=[2]"}}});
  c.integer("a");
  c.integer("b");
  c.integers("c");
  const std::string folder = scratch_.path().filename().string();
  EXPECT_EQ(c.resolved_with_origins(), fmt::format("{:<60} # {}/paper.toml:1\n{:<60} # shear/case.toml:2\n"
                                                   "{:<60} # --set c=[2]\n", "a = 1", folder, "b = 2", "c = [2]"));
}

TEST_F(ConfigurationOnABase, RefusesABaseThatIsNoneOrMissingOrHasABaseItself) {
  const auto of_case = [&](const std::string& text) {
    return complaint([&] { Configuration(Layers{scratch_.write("case.toml", text), "", {}, {}}); });
  };
  EXPECT_EQ(of_case("base = 3\n"), "case.toml:1:1: base is not a text; name a file, such as base = \"../paper.toml\"");
  EXPECT_CONTAINS(of_case("base = 'none.toml'\n"), "none.toml");
  scratch_.write("paper.toml", "base = 'deeper.toml'\n");
  EXPECT_EQ(of_case("base = 'paper.toml'\n"),
            "paper.toml:1:1: the base of a case.toml has no base of its own; take the key out");
  EXPECT_EQ(
      complaint([&] { read("", "base = 'paper.toml'\n"); }),
      "user.toml:1:1: a file for --config is laid over the case.toml of the case and has no base; take the key out");
}

TEST_F(LayeredConfiguration, BlamesTheFileThatHasTheTableForAMissingKey) {
  const std::string mine = "\n[point.mine]\nfigures = '3'\n[sample]\nlayers = 3\n";
  EXPECT_EQ(
      complaint([&] { read("quick", mine).text("point.mine.scheme"); }),
      "user.toml:2:8: [point.mine] lacks the key \"point.mine.scheme\": text is needed; add it there or with --set "
      "point.mine.scheme=VALUE");
  EXPECT_CONTAINS(complaint([&] { read("quick", "point.mine = { a = 1 }").text("point.mine.scheme"); }),
                  "user.toml:1:7: [point.mine] lacks");
  EXPECT_CONTAINS(complaint([&] {
                    read("", "", {{"point.mine.a", "1", "--set point.mine.a=1"}}).text("point.mine.scheme");
                  }),
                  "--set point.mine.a=1: [point.mine] lacks");
  // A table that both the case and the user's file have belongs to the case.
  EXPECT_CONTAINS(complaint([&] { read("quick", mine).text("sample.shape"); }),
                  "case.toml: the key \"sample.shape\" is missing");
  EXPECT_CONTAINS(complaint([&] { read("quick", mine).text("title"); }), "case.toml: the key \"title\" is missing");
  EXPECT_CONTAINS(complaint([&] { read("quick", mine).text("title"); }), "user.toml or with --set title=VALUE");
}

TEST_F(LayeredConfiguration, TellsWhichValuesAreOfTheUser) {
  const auto configuration = read("quick", "[sample]\nlayers = 3\n", {{"point.a.b", "1", "--set point.a.b=1"}});
  for (const char* users : {"sample", "sample.layers", "point", "point.a.b"})
    EXPECT_TRUE(configuration.is_users(users));
  for (const char* others : {"sample.lay", "point.a.b.c", "none"}) EXPECT_FALSE(configuration.is_users(others));
  EXPECT_FALSE(read("quick").is_users("sample"));
  EXPECT_CONTAINS(configuration.place_of({"sample.layers"}), "user.toml:2:1: sample.layers = 3");
}

}  // namespace
}  // namespace flowslide
