// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/elastic_sample.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

constexpr double rounding = 1e-10;  // Pa; sums of some ten numbers of 1e4 Pa

TEST(ElasticSample, AnswersStrainWithItsModuli) {
  ElasticSample sample({});
  EXPECT_EQ(sample.stress().shear, 2.65e3);
  EXPECT_EQ(sample.stress().normal, 28.34e3);
  const CellStress stress = sample.strain({{2.0, -0.5}, 100, 1e-6});
  EXPECT_NEAR(stress.shear, 2.65e3 + 15e6 * 2e-4, rounding);
  EXPECT_NEAR(stress.normal, 28.34e3 - 40e6 * 0.5e-4, rounding);
  EXPECT_EQ(stress.mean(), stress.normal);
  EXPECT_EQ(sample.mean_stress(), stress.normal);
  EXPECT_DOUBLE_EQ(sample.shear_strain(), 2e-4);
  sample.strain({{-2.0, 0.5}, 100, 1e-6});
  EXPECT_NEAR(sample.stress().shear, 2.65e3, rounding);
  EXPECT_NEAR(sample.stress().normal, 28.34e3, rounding);
}

TEST(ElasticSample, ViscosityAnswersTheRateOfTheLocalClock) {
  ElasticSample sample({.viscosity = 1e3});
  EXPECT_NEAR(sample.strain({{2.0, 0.0}, 100, 1e-6}).shear, 2.65e3 + 15e6 * 2e-4 + 1e3 * 2.0, rounding);
  // The same strain in twice the time.
  ElasticSample slow({.viscosity = 1e3});
  EXPECT_NEAR(slow.strain({{1.0, 0.0}, 200, 1e-6}).shear, 2.65e3 + 15e6 * 2e-4 + 1e3 * 1.0, rounding);
  const CellStress before = slow.stress();
  EXPECT_EQ(slow.strain({{5.0, 0.0}, 0, 1e-6}).shear, before.shear);  // no time passed
}

TEST(ElasticSample, CompressionTakesVoids) {
  ElasticSample sample({.void_ratio = 0.8});
  sample.strain({{1.0, 0.0}, 1000, 1e-6});
  EXPECT_DOUBLE_EQ(sample.void_ratio(), 0.8);
  sample.strain({{0.0, 1.0}, 1000, 1e-6});
  EXPECT_DOUBLE_EQ(sample.void_ratio(), 1.8 * (1.0 - 1e-3) - 1.0);
}

TEST(ElasticSample, RefusesWhatIsNotElastic) {
  EXPECT_THROW(ElasticSample({.shear_modulus = 0.0}), std::invalid_argument);
  EXPECT_THROW(ElasticSample({.oedometric_modulus = -1.0}), std::invalid_argument);
  EXPECT_THROW(ElasticSample({.viscosity = -1.0}), std::invalid_argument);
  EXPECT_THROW(ElasticSample({.void_ratio = 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
