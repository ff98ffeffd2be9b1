// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

Result with(std::vector<Metric> metrics) {
  Result result;
  result.metrics = std::move(metrics);
  return result;
}

Result state(double number, double friction) {
  return with({{"inertial_number", number, "1", "I"}, {"friction", friction, "1", "mu"}});
}

Result pulse(double grains, double velocity) {
  return with({{"grains", grains, "1", "N"}, {"largest_velocity", velocity, "m/s", "v_max"}});
}

Ensembles some_slides() {
  Ensembles slides;
  slides["hold_homogeneous"] = {with({{"linearity_2", 0.5, "1", ""}, {"linearity_3", 0.999, "1", ""},
                                      {"linearity_4", 0.99, "1", ""}}),
                                with({{"linearity_3", 0.998, "1", ""}})};
  slides["hold_glued"] = {with({{"linearity_3", 0.8, "1", ""}, {"linearity_4", 0.9, "1", ""}})};
  slides["pulse_homogeneous"] = {pulse(1100, 2.0), pulse(1100, 4.0), pulse(1100, 3.0)};
  slides["pulse_homogeneous_small"] = {pulse(400, 5.0)};
  slides["pulse_glued"] = {pulse(1100, 1.0)};
  const FrictionLaw law{0.3, 0.7, 0.1};
  for (const double number : {0.01, 0.03, 0.1, 0.3, 1.0}) slides["flow_loose"].push_back(state(number, law.at(number)));
  return slides;
}

TEST(Answers, LookAtLinearityAfterLiquefactionAlone) {
  std::map<std::string, double> metrics;
  add_answers(some_slides(), metrics);
  EXPECT_EQ(metrics.at("least_linearity"), 0.99);
  EXPECT_EQ(metrics.at("largest_glued_linearity"), 0.9);
}

TEST(Answers, FitTheSteadyStates) {
  EXPECT_EQ(steady_states(some_slides()).size(), 5u);
  Ensembles torn = some_slides();
  torn["flow_loose"][1].metrics.pop_back();  // without its friction, its inertial number is no state
  EXPECT_EQ(steady_states(torn).size(), 4u);
  EXPECT_EQ(steady_states(torn)[1].inertial_number, 0.1);
  std::map<std::string, double> metrics;
  add_answers(some_slides(), metrics);
  EXPECT_NEAR(metrics.at("mu_s"), 0.3, 2e-3);
  EXPECT_NEAR(metrics.at("mu_2"), 0.7, 2e-3);
  EXPECT_LT(metrics.at("mu_deviation"), metrics.at("mu_deviation_of_glass_beads"));
  std::map<std::string, double> none;
  add_answers({}, none);
  EXPECT_TRUE(none.empty());
}

TEST(Answers, AreATableOfBothSamples) {
  const std::string table = answers_table(some_slides());
  EXPECT_NE(table.find("| v_max after the pulse (m/s) | 1 | 3 (2 to 4) |"), std::string::npos) << table;
  EXPECT_NE(table.find("| v_max with 400 grains (m/s) | - | 5 |"), std::string::npos) << table;
  EXPECT_NE(table.find("| R^2 at 30 and 60 % strain, liquefied | 0.85 (0.8 to 0.9) | 0.998 (0.99 to 0.999) |"),
            std::string::npos)
      << table;
  EXPECT_NE(table.find("mu_s = 0.3"), std::string::npos) << table;
  EXPECT_NE(answers_table({}).find("| mu_ss of the held slope | - | - |"), std::string::npos);
}

TEST(Answers, SizesAreInOrder) {
  const Series sizes = sizes_series(some_slides(), "pulse_homogeneous");
  ASSERT_EQ(sizes.rows(), 2u);
  EXPECT_EQ(sizes.axis.values, (std::vector<double>{400, 1100}));
  EXPECT_EQ(sizes.columns[0].values, (std::vector<double>{5.0, 3.0}));
  EXPECT_EQ(sizes.columns[2].values, (std::vector<double>{5.0, 4.0}));
  EXPECT_EQ(sizes_series({}, "pulse_glued").rows(), 0u);
  // A closed-form sample has no grains.
  EXPECT_EQ(sizes_series({{"pulse_glued", {with({{"largest_velocity", 1.0, "m/s", "v_max"}})}}}, "pulse_glued").rows(),
            0u);
}

}  // namespace
}  // namespace flowslide
