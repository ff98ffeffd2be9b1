// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/critical_state_sample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

#include "sample/failure.hpp"

namespace flowslide::critical_state_sample_test {
namespace {

constexpr double step = 1e-5;

CriticalStateProperties at(double void_ratio) {
  CriticalStateProperties properties;
  properties.void_ratio = void_ratio;
  return properties;
}

/// Stress every 0.01 % of strain at constant volume.
std::vector<CellStress> undrained(CriticalStateSample& sample, double strain) {
  std::vector<CellStress> path{sample.stress()};
  for (double done = 0.0; done < strain; done += 1e-4) path.push_back(sample.strain({{1.0, 0.0}, 10, step}));
  return path;
}

double largest_shear(const std::vector<CellStress>& path) {
  double largest = 0.0;
  for (const CellStress& stress : path) largest = std::max(largest, stress.shear);
  return largest;
}

TEST(CriticalStateSample, BeginsWithTheStressesThatItWasGiven) {
  CriticalStateSample sample(at(0.79));
  EXPECT_EQ(sample.stress().normal, 28.34e3);
  EXPECT_DOUBLE_EQ(sample.stress().shear, 2.65e3);
  EXPECT_NEAR(sample.state_parameter(), 0.02, 1e-15);
}

TEST(CriticalStateSample, ShearingEndsAtTheCriticalState) {
  // At constant volume psi = 0 gives sigma = sigma_r exp((e_Gamma - e)/lambda), and tau = M sigma. Tolerance: what is
  // left of the exponential approach at 200 % strain, found by doubling the strain.
  for (const double void_ratio : {0.78, 0.77, 0.765}) {
    CriticalStateSample sample(at(void_ratio));
    undrained(sample, 2.0);
    const double expected = 28.34e3 * std::exp((0.77 - void_ratio) / 0.01);
    EXPECT_NEAR(sample.stress().normal, expected, 0.02 * expected) << void_ratio;
    EXPECT_NEAR(sample.stress().shear / sample.stress().normal, 0.4, 0.004) << void_ratio;
    EXPECT_DOUBLE_EQ(sample.void_ratio(), void_ratio);
    EXPECT_NEAR(sample.shear_strain(), 2.0, 2e-4);
  }
}

TEST(CriticalStateSample, LooseOneHasAPeakAndLiquefies) {
  CriticalStateSample sample(at(0.83));
  const auto path = undrained(sample, 1.0);
  const double peak = largest_shear(path);
  EXPECT_GT(peak, 3e3);
  EXPECT_LT(path.back().normal, 0.01 * 28.34e3);
  EXPECT_LT(path.back().shear, 0.05 * peak);
  for (const CellStress& stress : path) ASSERT_GT(stress.normal, 0.0);
}

TEST(CriticalStateSample, DenseOneContractsThenDilates) {
  CriticalStateSample sample(at(0.755));
  const auto path = undrained(sample, 0.5);
  const auto lowest = std::min_element(path.begin(), path.end(), [](const CellStress& a, const CellStress& b) {
    return a.normal < b.normal;
  });
  EXPECT_LT(lowest->normal, 0.98 * 28.34e3);
  EXPECT_GT(path.back().normal, 1.5 * 28.34e3);
}

TEST(CriticalStateSample, CompressionStiffensAsCamClayDoes) {
  CriticalStateProperties properties = at(0.79);
  properties.shear_stress = 0.0;
  CriticalStateSample sample(properties);
  sample.strain({{0.0, 0.1}, 100, step});  // 1e-4
  // sigma = sigma_0 exp(M_o/sigma epsilon); rounding of a hundred substeps.
  EXPECT_NEAR(sample.stress().normal, 28.34e3 * std::exp(1400.0 * 1e-4), 1e-7);
  EXPECT_EQ(sample.stress().shear, 0.0);
  EXPECT_NEAR(sample.void_ratio(), 1.79 * (1.0 - 1e-4) - 1.0, 1e-8);
}

TEST(CriticalStateSample, UnloadsElasticallyAndMirrorsItself) {
  CriticalStateSample sample(at(0.79));
  sample.strain({{1.0, 0.0}, 20, step});
  const CellStress before = sample.stress();
  const CellStress after = sample.strain({{-1.0, 0.0}, 1, step});
  EXPECT_NEAR(after.normal, before.normal, 1e-9);
  EXPECT_NEAR(before.shear - after.shear, 500.0 * before.normal * step, 1e-6);

  CriticalStateProperties upslope = at(0.79);
  upslope.shear_stress = -2.65e3;
  CriticalStateSample mirrored(upslope), straight(at(0.79));
  for (int n = 0; n < 5; ++n) {
    const CellStress a = straight.strain({{1.0, 0.1}, 50, step}), b = mirrored.strain({{-1.0, 0.1}, 50, step});
    EXPECT_DOUBLE_EQ(a.normal, b.normal);
    EXPECT_DOUBLE_EQ(a.shear, -b.shear);
  }
}

TEST(CriticalStateSample, KnowsNoRate) {
  CriticalStateSample fast(at(0.79)), slow(at(0.79));
  const CellStress a = fast.strain({{8.0, 0.0}, 128, step}), b = slow.strain({{2.0, 0.0}, 512, step});
  EXPECT_EQ(a.shear, b.shear);
  EXPECT_EQ(a.normal, b.normal);
}

TEST(CriticalStateSample, SubstepsConvergeWithFirstOrder) {
  const auto shear_after = [](double substep) {
    CriticalStateProperties properties = at(0.79);
    properties.largest_substep = substep;
    CriticalStateSample sample(properties);
    return sample.strain({{1.0, 0.0}, 512, 1.0 / 65536.0}).shear;  // 2^-7
  };
  const double coarse = shear_after(std::ldexp(1.0, -17)), fine = shear_after(std::ldexp(1.0, -18)),
               finer = shear_after(std::ldexp(1.0, -19));
  // Explicit Euler; the next order is a share substep * stiffness = 4e-6 * 1400 of the first.
  EXPECT_NEAR(std::log2((coarse - fine) / (fine - finer)), 1.0, 0.02);
}

TEST(CriticalStateSample, RefusesAStrainThatItCannotFollowInsteadOfTryingForEver) {
  for (const double rate : {1e300, -1e300, 1e7, std::nan("")}) {
    CriticalStateSample sample(at(0.79));
    EXPECT_THROW(sample.strain({{rate, 0.0}, 1, step}), NumericalFailure) << rate;
    EXPECT_THROW(sample.strain({{0.0, rate}, 1, step}), NumericalFailure) << rate;
  }
}

TEST(CriticalStateSample, RefusesWhatItCannotBear) {
  CriticalStateProperties steep = at(0.79);
  steep.shear_stress = 0.5 * steep.normal_stress;  // friction is 0.4 exp(-1.1 * 0.02)
  EXPECT_THROW(CriticalStateSample{steep}, std::invalid_argument);
  CriticalStateProperties nothing = at(0.79);
  nothing.normal_stress = 0.0;
  EXPECT_THROW(CriticalStateSample{nothing}, std::invalid_argument);
  EXPECT_THROW(CriticalStateSample(at(-0.1)), std::invalid_argument);
  CriticalStateProperties brittle = at(0.83);
  brittle.dilatancy = 50.0;
  CriticalStateSample sample(brittle);
  EXPECT_THROW(undrained(sample, 0.5), NumericalFailure);
}

}  // namespace
}  // namespace flowslide::critical_state_sample_test
