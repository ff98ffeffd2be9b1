// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace flowslide::slide_parameters_test {
namespace {

std::map<std::string, double> parameters(const SlidePoint& point, const std::optional<double>& number = {}) {
  std::map<std::string, double> values;
  for (const Metric& parameter : parameters_of(point, number)) values[parameter.name] = parameter.value;
  EXPECT_NO_THROW(check_metrics(parameters_of(point, number)));
  return values;
}

SlidePoint slide() {
  SlidePoint point;
  point.settings.slope.hydraulic_conductivity = 2e-5;
  point.settings.time_step = 1e-4;
  point.settings.passing = {CarryRemainder{10}, 7e-6, 1000};
  point.settings.loading = SinePulse{4e3, 2.0};
  return point;
}

TEST(SlideParameters, AreWhatASlideWasGiven) {
  const auto values = parameters(slide());
  EXPECT_EQ(values.at("hydraulic_conductivity"), 2e-5);
  EXPECT_EQ(values.at("amplitude"), 4e3);
  EXPECT_EQ(values.at("duration"), 2.0);
  EXPECT_EQ(values.at("time_step"), 1e-4);
  EXPECT_EQ(values.at("local_time_step"), 7e-6);
  EXPECT_EQ(values.at("least_steps"), 10.0);
  EXPECT_EQ(values.at("void_ratio"), 0.79);
  EXPECT_FALSE(values.contains("inertial_number"));
  EXPECT_FALSE(values.contains("loading_rate"));
}

TEST(SlideParameters, FollowTheRuleAndTheLoading) {
  SlidePoint point = slide();
  point.settings.rate = ConstantInertialNumber{1e-4, 3.0, {}};
  point.settings.loading = ConstantRate{1e4, 0.3};
  const auto values = parameters(point, 1e-4);
  EXPECT_EQ(values.at("inertial_number"), 1e-4);
  EXPECT_EQ(values.at("smallest_rate"), 3.0);
  EXPECT_EQ(values.at("loading_rate"), 1e4);
  EXPECT_EQ(values.at("loading_duration"), 0.3);
  EXPECT_FALSE(values.contains("amplitude"));
  point.settings.loading = ConstantRate{1e4};
  EXPECT_FALSE(parameters(point).contains("loading_duration"));  // it does not end
}

TEST(SlideParameters, OfAnElementTestAreItsRateAndStrain) {
  SlidePoint point = slide();
  point.test = ShearTest{0.3, 0.05};
  const auto values = parameters(point);
  EXPECT_EQ(values.at("shear_rate"), 0.3);
  EXPECT_EQ(values.at("final_strain"), 0.05);
  EXPECT_NEAR(values.at("inertial_number"), 0.3 * 6e-3 * std::sqrt(2650.0 / 28.34e3), 2e-5);  // about D of the lattice
  EXPECT_FALSE(values.contains("hydraulic_conductivity"));
}

TEST(Describe, NamesEveryLoadingWithItsValues) {
  EXPECT_EQ(describe(SinePulse{3e3, 2.0}), "pulse of 3 kPa over 2 s");
  EXPECT_EQ(describe(ConstantRate{1e4}), "10 kPa/s");
  EXPECT_EQ(describe(ConstantRate{1e4, 0.3}), "10 kPa/s for 0.3 s");
  EXPECT_EQ(describe(NoChange{}), "constant load");
  EXPECT_EQ(describe(StressTable{{0.0}, {6e3}}), "change of 6 kPa");
  EXPECT_EQ(describe(StressTable{{0.0, 1.0, 2.0}, {0.0, 1.0, 2.0}}), "table of 3 points");
}

}  // namespace
}  // namespace flowslide::slide_parameters_test
