// SPDX-License-Identifier: GPL-2.0-or-later
#include "claims/claims.hpp"

#include <limits>

#include "configuration/configuration.hpp"
#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr const char* two_claims = R"([[claim]]
id = "loosest_liquefies"
figure = "Fig. 3A"
sentence = "The loosest sample loses its strength."
metric = "residual_stress"
relation = "<"
threshold = "1 %"
unit = "1"
origin = "published"

[[claim]]
id = "void_ratio"
figure = "Fig. 3"
sentence = "e0 is 0.790."
metric = "void_ratio"
relation = "between"
threshold = [0.788, 0.792]
unit = "1"
origin = "rounding"
scales = ["paper"]
)";

std::vector<Claim> load(const std::string& text) {
  return load_claims(Configuration::from_text(text, "claims.toml")).claims;
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = two_claims;
  return text.replace(text.find(from), from.size(), to);
}

std::string complaint(const std::string& text) {
  return message_of<ConfigurationError>([&] { load(text); });
}

Claim claim(Relation relation, double threshold, double upper = 0.0) {
  Claim c{.id = "c", .figure = "Fig. 3", .sentence = "s", .metric = "m", .unit = "kPa", .origin = "o", .scales = {}};
  c.relation = relation;
  c.threshold = threshold;
  c.upper_threshold = relation == Relation::between ? upper : threshold;
  return c;
}

bool met(const Claim& c, double measured) { return evaluate({c}, {{"m", measured}}).front().ruling == Ruling::met; }

TEST(LoadClaims, ReadsEveryKey) {
  const auto claims = load(two_claims);
  ASSERT_EQ(claims.size(), 2U);
  EXPECT_EQ(claims[0].id, "loosest_liquefies");
  EXPECT_EQ(claims[0].figure, "Fig. 3A");
  EXPECT_EQ(claims[0].sentence, "The loosest sample loses its strength.");
  EXPECT_EQ(claims[0].metric, "residual_stress");
  EXPECT_EQ(claims[0].relation, Relation::less);
  EXPECT_EQ(claims[0].threshold, 0.01);
  EXPECT_EQ(claims[0].unit, "1");
  EXPECT_EQ(claims[0].origin, "published");
  EXPECT_TRUE(claims[0].scales.empty());
  EXPECT_EQ(claims[1].relation, Relation::between);
  EXPECT_EQ(claims[1].threshold, 0.788);
  EXPECT_EQ(claims[1].upper_threshold, 0.792);
  EXPECT_EQ(claims[1].scales, std::vector<std::string>{"paper"});
}

TEST(LoadClaims, ReadsAFile) {
  const ScratchFolder scratch;
  EXPECT_EQ(load_claims(scratch.write("claims.toml", two_claims)).claims.size(), 2U);
}

TEST(Claims, KnowTheRunsThatAreForAFigureAlone) {
  const ClaimsFile file = load_claims(Configuration::from_text("figure_only = ['RI_4kPa', 'RD_r2']\n"));
  for (const char* run : {"RI_4kPa", "RI_4kPa_r3", "RD_r2"}) EXPECT_TRUE(file.is_figure_only(run)) << run;
  for (const char* run : {"RI_4kPa2", "RI_4kPa_ramp", "RI_4kPa_r", "RD", "RD_r3", "RI"})
    EXPECT_FALSE(file.is_figure_only(run)) << run;
}

TEST(LoadClaims, SaysWhereAndWhatIsWrong) {
  EXPECT_EQ(complaint(with("origin", "orgin") + "origin = 'x'\n").substr(0, 12), "claims.toml:");
  EXPECT_CONTAINS(complaint(with("scales =", "scale =")),
                  "claims.toml:20:1: unknown key \"claim.1.scale\"; did you mean \"claim.1.scales\"?");
  EXPECT_CONTAINS(complaint(with("\"<\"", "\"=\"")), "claims.toml:6:12: claim.0.relation = \"=\" is not allowed");
  EXPECT_CONTAINS(complaint(with("[0.788, 0.792]", "0.79")), "claims.toml:17:13: claim.1.threshold = 0.79 has 1 ");
  EXPECT_CONTAINS(complaint(with("\"1 %\"", "[1, 2]")), "has 2 value(s), but the relation \"<\" needs 1");
  EXPECT_CONTAINS(complaint(with("[0.788, 0.792]", "[0.8, 0.7]")), "upper bound below");
  EXPECT_CONTAINS(complaint(with("\"void_ratio\"", "\"loosest_liquefies\"")), "claims.toml:12:6: ");
  EXPECT_CONTAINS(complaint(with("\"void_ratio\"", "\"a b\"")), "is not a name");
  EXPECT_CONTAINS(complaint(with("[\"paper\"]", "[\"big\"]")), "it must be \"quick\" or \"paper\"");
  EXPECT_CONTAINS(complaint(with("unit = \"1\"\norigin = \"published\"", "unit = \"1\"")), "claim.0.origin");
}

TEST(ClaimsAt, ChoosesByScale) {
  const auto claims = load(two_claims);
  EXPECT_EQ(claims_at(claims, "quick").size(), 1U);
  EXPECT_EQ(claims_at(claims, "paper").size(), 2U);
}

TEST(Evaluate, KnowsEachRelationAtItsEdge) {
  EXPECT_FALSE(met(claim(Relation::less, 1.0), 1.0));
  EXPECT_TRUE(met(claim(Relation::less, 1.0), 0.9));
  EXPECT_TRUE(met(claim(Relation::at_most, 1.0), 1.0));
  EXPECT_FALSE(met(claim(Relation::at_most, 1.0), 1.1));
  EXPECT_FALSE(met(claim(Relation::greater, 1.0), 1.0));
  EXPECT_TRUE(met(claim(Relation::greater, 1.0), 1.1));
  EXPECT_TRUE(met(claim(Relation::at_least, 1.0), 1.0));
  EXPECT_FALSE(met(claim(Relation::at_least, 1.0), 0.9));
  EXPECT_TRUE(met(claim(Relation::between, 1.0, 2.0), 1.0));
  EXPECT_TRUE(met(claim(Relation::between, 1.0, 2.0), 2.0));
  EXPECT_FALSE(met(claim(Relation::between, 1.0, 2.0), 0.9));
  EXPECT_FALSE(met(claim(Relation::between, 1.0, 2.0), 2.1));
}

TEST(Evaluate, SaysNothingOfAMissingMetric) {
  const Verdict verdict = evaluate({claim(Relation::less, 1.0)}, {{"other", 0.5}}).front();
  EXPECT_EQ(verdict.ruling, Ruling::not_evaluated);
  EXPECT_EQ(verdict.reason, "the metric \"m\" was not measured");
}

TEST(Evaluate, SaysNothingOfWhatIsNotFinite) {
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                             -std::numeric_limits<double>::infinity()}) {
    const Verdict verdict = evaluate({claim(Relation::less, 1.0)}, {{"m", value}}).front();
    EXPECT_EQ(verdict.ruling, Ruling::not_evaluated);
    EXPECT_CONTAINS(verdict.reason, "not a finite number");
  }
}

TEST(Evaluate, GivesTheComparisonAsReason) {
  EXPECT_EQ(evaluate({claim(Relation::less, 1.0)}, {{"m", 2.5}}).front().reason, "2.5 is not < 1 kPa");
  EXPECT_EQ(evaluate({claim(Relation::between, 1.0, 3.0)}, {{"m", 2.5}}).front().reason, "2.5 is between 1 and 3 kPa");
}

TEST(IsOneNotMet, CountsThoseThatAreEvaluatedAlone) {
  const auto c = claim(Relation::less, 1.0);
  EXPECT_FALSE(is_one_not_met({}));
  EXPECT_FALSE(is_one_not_met(evaluate({c}, {{"m", 0.0}})));
  EXPECT_FALSE(is_one_not_met(evaluate({c}, {})));
  EXPECT_TRUE(is_one_not_met(evaluate({c, claim(Relation::greater, 1.0)}, {{"m", 0.0}})));
}

TEST(NotEvaluated, KeepsWhatWasMeasured) {
  const auto verdicts = not_evaluated(evaluate({claim(Relation::less, 1.0)}, {{"m", 5.0}}), "another study");
  EXPECT_EQ(verdicts.front().measured, 5.0);
  EXPECT_EQ(verdicts.front().ruling, Ruling::not_evaluated);
  EXPECT_EQ(verdicts.front().reason, "another study");
  EXPECT_FALSE(is_one_not_met(verdicts));
}

TEST(FiguresIn, AreThoseThatAClaimNames) {
  EXPECT_EQ(figures_in("Fig. 3A"), (std::set<std::string>{"3"}));
  EXPECT_EQ(figures_in("Fig. 4"), (std::set<std::string>{"4"}));
  EXPECT_TRUE(figures_in("Figs. 6C and 7C").contains("6"));
  EXPECT_TRUE(figures_in("Figs. 6C and 7C").contains("7"));
  EXPECT_EQ(figures_in("Fig. speed_error"), (std::set<std::string>{"speed_error"}));
  EXPECT_TRUE(figures_in("sec. 2.3").empty());
}

}  // namespace
}  // namespace flowslide
