// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/sample_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "sample/critical_state_sample.hpp"
#include "sample/elastic_sample.hpp"

namespace flowslide {
namespace {

TEST(SampleState, GivesNumbersByName) {
  const SampleState state{{{"time", 0.1}, {"steps", 12.0}}, {}};
  EXPECT_EQ(state.number("time"), 0.1);
  EXPECT_EQ(state.count("steps"), 12);
  EXPECT_THROW(state.number("stress"), std::invalid_argument);
}

TEST(SampleState, TakesNoCountFromWhatIsNone) {
  for (const double value : {-1.0, 0.5, 1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
    const SampleState state{{{"steps", value}}, {}};
    EXPECT_THROW(state.count("steps"), std::invalid_argument) << value;
  }
}

/// A sample is strained to and fro and stored half-way. A second sample continues from this state with the same bits.
template <typename Made>
void expect_to_go_on(Made make) {
  auto whole = make(), first = make(), second = make();
  const auto strain = [](Sample& sample, int from, int to) {
    for (int i = from; i < to; ++i) sample.strain({{std::sin(0.7 * i), 1e-2 * std::cos(i)}, 100, 1e-6});
  };
  strain(whole, 0, 40);
  strain(first, 0, 17);
  second.restore(first.state());
  strain(second, 17, 40);
  EXPECT_EQ(second.stress().shear, whole.stress().shear);
  EXPECT_EQ(second.stress().normal, whole.stress().normal);
  EXPECT_EQ(second.void_ratio(), whole.void_ratio());
  EXPECT_EQ(second.shear_strain(), whole.shear_strain());
  EXPECT_THROW(second.restore(SampleState{}), std::invalid_argument);
}

TEST(SampleState, ClosedFormSamplesGoOnFromIt) {
  expect_to_go_on([] { return ElasticSample({.viscosity = 1e3}); });
  expect_to_go_on([] { return CriticalStateSample({}); });
}

}  // namespace
}  // namespace flowslide
