// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/symbols.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

const std::vector<std::string> keys{"coupling.local_time_step",
                                    "coupling.time_step",
                                    "elastic.void_ratio",
                                    "loading.amplitude",
                                    "loading.duration",
                                    "material.sliding_friction",
                                    "point.RD.loading.amplitude",
                                    "sample.loose.void_ratio",
                                    "shear.time_step",
                                    "slope.angle",
                                    "slope.hydraulic_conductivity"};

TEST(Symbols, NameTheKeysThatTheyStandFor) {
  EXPECT_EQ(keys_of_symbol("k"), std::vector<std::string>{"hydraulic_conductivity"});
  EXPECT_EQ(keys_of_symbol("e_0"), keys_of_symbol("e0"));
  EXPECT_EQ(keys_of_symbol("dt_L").front(), "local_time_step");
  EXPECT_NE(keys_of_symbol("E"), keys_of_symbol("e"));
  EXPECT_TRUE(keys_of_symbol("amplitude").empty());
  EXPECT_TRUE(keys_of_symbol("").empty());
}

TEST(Symbols, AreTakenForTheKeyInTheNearestTable) {
  EXPECT_EQ(key_meant("slope.k", keys), "slope.hydraulic_conductivity");
  EXPECT_EQ(key_meant("A", keys), "loading.amplitude");
  EXPECT_EQ(key_meant("point.RD.loading.A", keys), "point.RD.loading.amplitude");
  EXPECT_EQ(key_meant("loading.T", keys), "loading.duration");
  EXPECT_EQ(key_meant("sample.loose.e0", keys), "sample.loose.void_ratio");
  EXPECT_EQ(key_meant("slope.theta", keys), "slope.angle");
  EXPECT_EQ(key_meant("mu", keys), "material.sliding_friction");
  EXPECT_EQ(key_meant("shear.dt_L", {"shear.time_step"}), "shear.time_step");  // where a step has no other name
}

TEST(Symbols, AreNothingWhereNoKeyFits) {
  EXPECT_EQ(key_meant("slope.K", keys), "");
  EXPECT_EQ(key_meant("slope.nu", keys), "");
  EXPECT_EQ(key_meant("k", {}), "");
}

}  // namespace
}  // namespace flowslide
