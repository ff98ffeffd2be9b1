// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/slide_series.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(SlideSeries, NamesEveryColumnOnce) {
  const Series series = slide_series();
  EXPECT_NO_THROW(series.check());
  EXPECT_EQ(series.rows(), 0U);
}

}  // namespace
}  // namespace flowslide
