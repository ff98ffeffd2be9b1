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

TEST(Configuration, ProposesTheKeyOfASymbol) {
  const auto c = Configuration::from_text("[slope]\nk = 1\n[loading]\nA = 2\n", "mine.toml");
  c.has("slope.hydraulic_conductivity");
  c.accept("loading.amplitude");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.reject_unknown(); }),
            "mine.toml:2:1: unknown key \"slope.k\"; did you mean \"slope.hydraulic_conductivity\"?\n"
            "mine.toml:4:1: unknown key \"loading.A\"; did you mean \"loading.amplitude\"?");
}

TEST(Configuration, ProposesTheTableOfAKeyThatStandsOutsideIt) {
  const auto c = Configuration::from_text("angle = 1\n", "mine.toml");
  c.has("slope.angle");
  c.has("engine");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.reject_unknown(); }),
            "mine.toml:1:1: unknown key \"angle\"; did you mean \"slope.angle\"?");
}

TEST(Configuration, RefusesByARuleOverSeveralKeys) {
  const auto c = Configuration::from_text("dt = \"1 s\"\n", "case.toml");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.refuse("dt", "is above 0.65 Rayleigh times, 4e-6 s", "lower it"); }),
            "case.toml:1:6: dt = \"1 s\" is above 0.65 Rayleigh times, 4e-6 s; lower it");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.refuse("absent", "is odd", "make it even"); }),
            "case.toml: absent is odd; make it even");
}

TEST(Configuration, KnowsWhatWasAcceptedOrAskedFor) {
  const auto c = Configuration::from_text("a = 1\n[t]\nb = 2\n[u]\nd = 3\n", "case.toml");
  EXPECT_TRUE(c.has("a"));
  EXPECT_FALSE(c.has("nothing"));
  EXPECT_TRUE(c.has("u"));
  c.accept("t");
  EXPECT_EQ(message_of<ConfigurationError>([&] { c.reject_unknown(); }),
            "case.toml:5:1: unknown key \"u.d\"; no known name is similar; --dry-run prints all keys");
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
