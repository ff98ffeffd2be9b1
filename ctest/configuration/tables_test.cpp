// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/tables.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr const char* text = R"([coupling]
time_step = 1e-4
n_accum = 10
[point.near.coupling]
time_step = 1e-5
)";

TEST(Tables, ReadAKeyFromTheFirstTableThatHasIt) {
  const auto configuration = Configuration::from_text(text);
  const Tables tables(configuration, {"point.near.coupling", "coupling"});
  EXPECT_EQ(tables.number("time_step", Range::positive()), 1e-5);
  EXPECT_EQ(tables.integer("n_accum", Range::positive()), 10);
  EXPECT_EQ(tables.key("time_step"), "point.near.coupling.time_step");
  EXPECT_EQ(tables.key("n_accum"), "coupling.n_accum");
  EXPECT_FALSE(tables.has("rate"));
  EXPECT_NO_THROW(configuration.reject_unknown());  // the key that is overridden is known, too
}

TEST(Tables, RefuseAUsersValueWithoutEffect) {
  const ScratchFolder folder;
  const auto file = folder.write("case.toml", text);
  const auto read = [&](const std::string& key) {
    const Configuration configuration(Layers{file, "", {}, {{key, "2e-4", "--set " + key + "=2e-4"}}});
    Tables(configuration, {"point.near.coupling", "coupling"}).number("time_step", Range::positive());
    configuration.number("coupling.n_accum");
    configuration.reject_unknown();
  };
  EXPECT_NO_THROW(read("point.near.coupling.time_step"));
  EXPECT_EQ(message_of<ConfigurationError>([&] { read("coupling.time_step"); }),
            "--set coupling.time_step=2e-4: \"coupling.time_step\" has no effect: every run that could use it has a "
            "nearer key, such as \"point.near.coupling.time_step\"; set that key instead");
}

TEST(Tables, NameTheLastTableIfAKeyIsMissing) {
  const auto configuration = Configuration::from_text(text);
  const Tables tables(configuration, {"point.near.coupling", "coupling"});
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { tables.positive("rate", dimension::rate); }), "coupling.rate");
}

TEST(Tables, NameTheUsersTableIfAKeyIsMissing) {
  const ScratchFolder folder;
  const auto file = folder.write("case.toml", text);
  const auto own = folder.write("mine.toml", "[point.mine]\nfigures = '3'\n[scheme.mine]\nn_accum = 3\n");
  const Configuration configuration(Layers{file, "", own, {}});
  const Tables tables(configuration, {"point.mine.coupling", "scheme.mine", "coupling"});
  EXPECT_EQ(tables.integer("n_accum", Range::positive()), 3);
  EXPECT_EQ(tables.number("time_step", Range::positive()), 1e-4);
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { tables.positive("rate", dimension::rate); }),
                  "mine.toml:3:9: [scheme.mine] lacks the key \"scheme.mine.rate\": a rate, above 0 1/s is needed");
}

TEST(Tables, NameTheTableOfAValueThatIsRefused) {
  const auto configuration = Configuration::from_text(text);
  const Tables tables(configuration, {"point.near.coupling", "coupling"});
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { tables.number("time_step", Range::at_least(1.0)); }),
                  "text:5:13: point.near.coupling.time_step");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { tables.refuse("n_accum", "is odd", "make it even"); }),
                  "coupling.n_accum = 10 is odd");
}

TEST(Tables, AcceptKeysInEach) {
  const auto configuration = Configuration::from_text(text);
  Tables(configuration, {"point.near.coupling", "coupling"}).accept({"time_step", "n_accum"});
  EXPECT_NO_THROW(configuration.reject_unknown());
}

TEST(Tables, AreReadBeforeTheTableThatTheyAreLike) {
  const auto configuration = Configuration::from_text(R"([sample]
a = { n = 1 }
b = { like = 'a' }
c = { like = 'd' }
e = { like = 'f' }
f = { like = 'b' }
g = { like = 'h' }
h = { like = 'g' }
)");
  EXPECT_EQ(with_like(configuration, "sample", "e"),
            (std::vector<std::string>{"sample.e", "sample.f", "sample.b", "sample.a"}));
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { with_like(configuration, "sample", "g"); }),
                  "sample.h.like = 'g' closes a loop of tables, each like the next");
  EXPECT_EQ(with_like(configuration, "sample", "a"), std::vector<std::string>{"sample.a"});
  const std::vector<std::string> tables = with_like(configuration, "sample", "b");
  EXPECT_EQ(tables, (std::vector<std::string>{"sample.b", "sample.a"}));
  EXPECT_EQ(within(tables, "packing", {"packing"}).names(),
            (std::vector<std::string>{"sample.b.packing", "sample.a.packing", "packing"}));
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { with_like(configuration, "sample", "c"); }),
                  "sample.c.like = 'd' is not allowed");
}

TEST(Tables, RecordsWhatATableTakesFromAnotherByLike) {
  const auto configuration = Configuration::from_text(
      "[sample.a]\ndrag = 1\nmode = 1\n[sample.b]\nlike = 'a'\nmode = 2\n[packing]\nsize = 3\n", "case.toml");
  const std::vector<std::string> tables = with_like(configuration, "sample", "b");
  Tables(configuration, tables).integer("drag", Range::any());
  Tables(configuration, tables).integer("mode", Range::any());
  Tables(configuration, within(tables, "packing", {"packing"})).integer("size", Range::any());
  const std::string inherited = configuration.inherited_with_origins("sample");
  EXPECT_CONTAINS(inherited, "sample.b.drag = 1 ");
  EXPECT_CONTAINS(inherited, " # like sample.a, case.toml:2\n");
  EXPECT_EQ(inherited.find("mode"), std::string::npos);
  EXPECT_EQ(inherited.find("size"), std::string::npos);
}

}  // namespace
}  // namespace flowslide
