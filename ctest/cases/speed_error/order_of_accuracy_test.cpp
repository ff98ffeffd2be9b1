// SPDX-License-Identifier: GPL-2.0-or-later
#include "order_of_accuracy.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace flowslide {
namespace {

constexpr double bisection = 1e-6;

TEST(OrderOfAccuracy, IsFoundThoughTheReferenceIsNotExact) {
  for (const double order : {0.5, 1.0, 2.0, 3.0}) {
    const auto error = [&](double step) { return 7.0 * (std::pow(step, order) - std::pow(5e-7, order)); };
    EXPECT_NEAR(order_of_accuracy({{2e-6, error(2e-6)}, {1e-5, error(1e-5)}, {5e-6, error(5e-6)}}, 5e-7), order,
                bisection);
  }
}

TEST(OrderOfAccuracy, IsNoneWithoutTwoErrorsThatGrowWithTheStep) {
  EXPECT_TRUE(std::isnan(order_of_accuracy({}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, 0.1}}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, 0.1}, {1e-5, 0.2}}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, 0.1}, {5e-6, 0.0}}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, 0.1}, {5e-6, 0.2}}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, 0.1}, {5e-7, 0.05}}, 5e-7)));
  EXPECT_TRUE(std::isnan(order_of_accuracy({{1e-5, std::nan("")}, {5e-6, 0.2}}, 5e-7)));
}

}  // namespace
}  // namespace flowslide
