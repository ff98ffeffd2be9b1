// SPDX-License-Identifier: GPL-2.0-or-later
#include "friction_law.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

std::vector<SteadyState> states_of(const FrictionLaw& law, double noise = 0.0) {
  std::vector<SteadyState> states;
  for (const double number : {1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0})
    states.push_back({number, law.at(number) + (states.size() % 2 ? noise : -noise)});
  return states;
}

TEST(FrictionLaw, OfGlassBeadsIsThePublishedOne) {
  const FrictionLaw law = law_of_glass_beads();
  EXPECT_NEAR(law.slow, 0.382, 5e-4);
  EXPECT_NEAR(law.fast, 0.643, 5e-4);
  EXPECT_NEAR(law.at(0.279), 0.5 * (law.slow + law.fast), 1e-12);
  EXPECT_NEAR(law.at(1e-9), law.slow, 1e-8);
}

TEST(FrictionLaw, TheFitFindsTheLawThatMadeTheStates) {
  const FrictionLaw law{0.3, 0.7, 0.05}, found = fit_friction_law(states_of(law));
  // I_0 is searched in steps of 1.7 %.
  EXPECT_NEAR(found.turning, law.turning, 0.02 * law.turning);
  EXPECT_NEAR(found.slow, law.slow, 2e-3);
  EXPECT_NEAR(found.fast, law.fast, 2e-3);
  EXPECT_LT(deviation(states_of(law), found), 1e-3);
}

TEST(FrictionLaw, TheFitIsNoWorseThanTheLawBehindNoisyStates) {
  const FrictionLaw law{0.3, 0.7, 0.05};
  const std::vector<SteadyState> states = states_of(law, 0.02);
  EXPECT_NEAR(deviation(states, law), 0.02, 1e-12);
  EXPECT_LE(deviation(states, fit_friction_law(states)), 0.02);
}

TEST(FrictionLaw, RefusesWhatTellsNoLaw) {
  const std::vector<SteadyState> states = states_of({0.3, 0.7, 0.05});
  EXPECT_TRUE(tell_a_law(states));
  EXPECT_FALSE(tell_a_law({}));
  EXPECT_FALSE(tell_a_law(std::vector<SteadyState>(5, {0.1, 0.4})));
  EXPECT_THROW(fit_friction_law({states.begin(), states.begin() + 3}), std::invalid_argument);
  EXPECT_THROW(fit_friction_law(std::vector<SteadyState>(5, {0.1, 0.4})), std::invalid_argument);
  EXPECT_THROW(fit_friction_law({{0.0, 0.3}, {0.1, 0.4}, {0.2, 0.4}, {0.3, 0.4}}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
