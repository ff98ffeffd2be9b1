// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/configuration.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <random>

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

TEST_F(LayeredConfiguration, ReadsTheBase) {
  EXPECT_EQ(read().integer("sample.layers"), 20);
  EXPECT_EQ(stress_of(read()), 28340.0);
}

TEST_F(LayeredConfiguration, LaysTheScaleOverTheBase) {
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
            "user.toml:1:1: unknown key \"x\"; none is like it; --dry-run prints those there are\n"
            "user.toml:2:1: unknown key \"y\"; none is like it; --dry-run prints those there are");
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

TEST(Configuration, MayHaveOneMoreLayerThatLeavesItAsItWas) {
  const Configuration configuration = Configuration::from_text("[a]\nb = 1\nc = 2\n");
  const Configuration overlaid = configuration.overlaid("[a]\nb = 3\n", "trial");
  EXPECT_EQ(overlaid.integer("a.b"), 3);
  EXPECT_EQ(overlaid.integer("a.c"), 2);
  EXPECT_EQ(configuration.integer("a.b"), 1);
}

TEST(Configuration, GivesSubtablesInTheOrderOfTheFile) {
  const auto c = Configuration::from_text("[p.z]\n[p.a]\nx = 1\n[[q]]\ny = 1\n[[q]]\ny = 2\n");
  EXPECT_EQ(c.subtables("p"), (std::vector<std::string>{"z", "a"}));
  EXPECT_EQ(c.subtables("q"), (std::vector<std::string>{"0", "1"}));
  EXPECT_EQ(c.integer("q.1.y"), 2);
  EXPECT_TRUE(c.subtables("none").empty());
}

TEST(Configuration, RefusesValuesWhereTablesAreNeeded) {
  const auto c = Configuration::from_text("p = 1\nq = [1]\n[r]\ns = 2\n", "case.toml");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { c.subtables("p"); }), "case.toml:1:5: p = 1 is a value");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { c.subtables("q"); }), "case.toml:2:5: q = [1] is a list");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { c.subtables("r"); }), "case.toml:4:5: r.s = 2 is a value");
}

TEST(Configuration, NamesAMissingKeyAndWhatMayBeAMisspellingOfIt) {
  const auto c = Configuration::from_text("[sample]\nconfinig_stress = 3\n", "case.toml");
  EXPECT_EQ(
      message_of<ConfigurationError>(
          [&] { c.quantity("sample.confining_stress", dimension::stress, Range::positive()); }),
      "case.toml: the key \"sample.confining_stress\" is missing: a stress, above 0 Pa is needed; add it there or "
      "with --set sample.confining_stress=VALUE (is \"sample.confinig_stress\" at case.toml:2:1 a misspelling of "
      "it?)");
  EXPECT_CONTAINS_NOT(message_of<ConfigurationError>([&] { c.flag("verbose"); }), "misspelling");
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
  // A table of the case that the user's file goes on with is the case's.
  EXPECT_CONTAINS(complaint([&] { read("quick", mine).text("sample.shape"); }),
                  "case.toml: the key \"sample.shape\" is missing");
  EXPECT_CONTAINS(complaint([&] { read("quick", mine).text("title"); }), "case.toml: the key \"title\" is missing");
}

TEST(Configuration, ProposesTheKeyOfASymbol) {
  const auto c = Configuration::from_text("[slope]\nk = 1\n[loading]\nA = 2\n", "mine.toml");
  c.has("slope.hydraulic_conductivity");
  c.accept("loading.amplitude");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.reject_unknown(); }),
            "mine.toml:2:1: unknown key \"slope.k\"; did you mean \"slope.hydraulic_conductivity\"?\n"
            "mine.toml:4:1: unknown key \"loading.A\"; did you mean \"loading.amplitude\"?");
}

TEST(Configuration, RefusesByARuleOverSeveralKeys) {
  const auto c = Configuration::from_text("dt = \"1 s\"\n", "case.toml");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.refuse("dt", "is above 0.65 Rayleigh times, 4e-6 s", "lower it"); }),
            "case.toml:1:6: dt = \"1 s\" is above 0.65 Rayleigh times, 4e-6 s; lower it");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.refuse("absent", "is odd", "mend it"); }),
            "case.toml: absent is odd; mend it");
}

TEST(Configuration, KnowsWhatWasAcceptedOrAskedFor) {
  const auto c = Configuration::from_text("a = 1\n[t]\nb = 2\n[u]\nd = 3\n", "case.toml");
  EXPECT_TRUE(c.has("a"));
  EXPECT_FALSE(c.has("nothing"));
  EXPECT_TRUE(c.has("u"));
  c.accept("t");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.reject_unknown(); }),
            "case.toml:5:1: unknown key \"u.d\"; none is like it; --dry-run prints those there are");
  c.accept("u.d");
  EXPECT_NO_THROW(c.reject_unknown());
}

TEST(Configuration, ResolvesToSortedTomlInSiUnits) {
  const auto c = Configuration::from_text(
      "z = 'a \"b\"'\n[s]\nstress = '28.34 kPa'\nratio = '25 %'\nn = 3\non = true\nunread = 1\n"
      "rates = ['1 mm/s', '2 m/s']\n[[p]]\nk = 1\n[[p]]\n");
  c.text("z");
  c.quantity("s.stress", dimension::stress);
  c.number("s.ratio");
  c.integer("s.n");
  c.flag("s.on");
  c.quantities("s.rates", dimension::velocity);
  c.subtables("p");
  c.integers("p.0.k");
  EXPECT_EQ(c.resolved(),
            "p.0.k = [1]\n"
            "p.1 = {}\n"
            "s.n = 3\n"
            "s.on = true\n"
            "s.rates = [\"0.001 m/s\", \"2.0 m/s\"]\n"
            "s.ratio = 0.25\n"
            "s.stress = \"28340.0 Pa\"\n"
            "z = \"a \\\"b\\\"\"\n");
}

TEST(Configuration, ResolvedTextReadsBackToItself) {
  const auto read_all = [](const Configuration& c) {
    c.quantity("a.time", dimension::time);
    for (const std::string& name : c.subtables("p"))
      if (c.has("p." + name + ".k")) c.number("p." + name + ".k");
    c.texts("names");
    c.reject_unknown();
    return c.resolved();
  };
  std::string text = "names = ['x', 'y\\z']\n[a]\ntime = '0.1 ms'\n";
  for (int i = 0; i < 12; ++i) text += "[[p]]\nk = 0.1\n";
  text += "[[p]]\n";
  const std::string resolved = read_all(Configuration::from_text(text));
  EXPECT_EQ(read_all(Configuration::from_text(resolved)), resolved);
}

TEST(Configuration, ResolvedQuantitiesAreTheSameBits) {
  std::mt19937_64 random(18);
  for (const Dimension& dimension : {dimension::dimensionless, dimension::angle,        dimension::mass,
                                     dimension::length,        dimension::time,         dimension::rate,
                                     dimension::velocity,      dimension::acceleration, dimension::area,
                                     dimension::volume,        dimension::density,      dimension::unit_weight,
                                     dimension::force,         dimension::stress,       dimension::stress_rate,
                                     dimension::viscosity,     dimension::mass_rate,    dimension::compressibility,
                                     dimension::energy,        Dimension{1, -2, 3, -1}}) {
    const auto read = [&](const std::string& text) {
      const auto c = Configuration::from_text(text);
      std::vector<double> values = c.quantities("list", dimension);
      values.push_back(c.quantity("one", dimension));
      return std::pair(values, c.resolved());
    };
    for (int i = 0; i < 200; ++i) {
      const auto value = std::bit_cast<double>(random());
      if (!std::isfinite(value)) continue;
      const std::string written = fmt::format("{} {}", value, unit_of(dimension));
      const auto [values, resolved] = read(fmt::format("one = '{0}'\nlist = ['{0}', 0, '{0}']\n", written));
      EXPECT_EQ(values, (std::vector{value, 0.0, value, value})) << written;
      EXPECT_EQ(read(resolved), std::pair(values, resolved));
    }
  }
}

TEST(Configuration, ResolvedTextFollowsTheValuesNotTheirSpelling) {
  const auto resolved = [](const std::string& text) {
    const auto c = Configuration::from_text(text);
    c.quantity("s.stress", dimension::stress);
    return c.resolved();
  };
  EXPECT_EQ(resolved("[s]\nstress = '28.34 kPa'"), resolved("# other\ns = { stress = '28340 Pa' }"));
  EXPECT_NE(resolved("[s]\nstress = '28.34 kPa'"), resolved("[s]\nstress = '28.341 kPa'"));
}

TEST(ConfigurationChanges, AreTheValuesThatTheCaseHasOtherwise) {
  const ScratchFolder scratch;
  const Layers layers{.case_file = scratch.write("case.toml", "a = '3 kPa'\nb = [1, 2]\nc = 1\n[scale.quick]\nc = 2\n"),
                      .scale = "quick",
                      .user_file = scratch.write("user.toml", "b = [1, 3]\nd = 5\n"),
                      .overrides = {{"a", "3 kPa", "--set a"}, {"c", "1", "--set c"}}};
  const Configuration configuration(layers);
  EXPECT_TRUE(configuration.changes().empty());  // nothing has been read
  configuration.quantity("a", dimension::stress);
  configuration.numbers("b");
  configuration.number("c");
  configuration.number("d");
  const std::vector<Change> changes = configuration.changes();
  ASSERT_EQ(changes.size(), 3U);
  EXPECT_EQ(changes[0].key, "b");
  EXPECT_EQ(changes[0].value, "[1.0, 3.0]");
  EXPECT_EQ(changes[0].before, "[1, 2]");
  EXPECT_EQ(changes[1].key, "c");
  EXPECT_EQ(changes[1].before, "2");
  EXPECT_EQ(changes[2].key, "d");
  EXPECT_EQ(changes[2].before, "");
  EXPECT_TRUE(configuration.is_published("c"));
  EXPECT_FALSE(configuration.is_published("d"));
}

TEST(Configuration, RefusesARenamedKeyWithItsNewName) {
  const ScratchFolder scratch;
  const auto file = scratch.write("case.toml", "a.b = 1\n[scale.big]\na.old = 2\n[scale.small]\n");
  const Configuration configuration({.case_file = file, .scale = "small", .user_file = {}, .overrides = {}});
  EXPECT_NO_THROW(configuration.refuse_renamed("a.other", "a.b"));
  EXPECT_EQ(message_of<ConfigurationError>([&] { configuration.refuse_renamed("a.old", "a.b"); }),
            file.string() + ":3:3: \"a.old\" is called \"a.b\" now; rename it");
}

}  // namespace
}  // namespace flowslide
