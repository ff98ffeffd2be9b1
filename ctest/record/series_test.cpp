// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/series.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "example.hpp"

namespace flowslide {
namespace {

std::string refusal(const Series& series) {
  try {
    series.check();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Series, AppendsWholeRowsOnly) {
  Series series = example_series(0);
  series.append_row(0.5, std::array{1.0, 2.0, 3.0});
  EXPECT_EQ(series.rows(), 1);
  EXPECT_EQ(series.columns[2].values, std::vector{3.0});
  EXPECT_THROW(series.append_row(0.6, std::array{1.0, 2.0}), std::invalid_argument);
  EXPECT_EQ(series.rows(), 1);
  EXPECT_EQ(series.columns[0].values.size(), 1);
}

TEST(Series, FindsColumnsByNameAndNamesThoseThereAre) {
  const Series series = example_series();
  EXPECT_EQ(series.column("time").symbol, "t");
  EXPECT_EQ(series.column("inertial_number").symbol, "I");
  try {
    series.column("sheer_stress");
    FAIL();
  } catch (const std::out_of_range& error) {
    EXPECT_NE(std::string(error.what()).find("time, shear_stress, normal_stress"), std::string::npos) << error.what();
  }
}

TEST(Series, AcceptsOnlyWhatCanBeWritten) {
  EXPECT_EQ(refusal(example_series()), "accepted");
  EXPECT_EQ(refusal(example_series(0)), "accepted");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Series series = example_series();
    series.columns[1].values[7] = bad;
    EXPECT_NE(refusal(series).find("'normal_stress'"), std::string::npos) << refusal(series);
    EXPECT_NE(refusal(series).find("row 7"), std::string::npos) << refusal(series);
  }
  Series series = example_series();
  series.axis.values[3] = std::nan("");
  EXPECT_NE(refusal(series).find("'time'"), std::string::npos);
}

TEST(Series, RefusesMisfittingColumns) {
  Series longer = example_series();
  longer.columns[0].values.push_back(1.0);
  EXPECT_NE(refusal(longer).find("51 rows"), std::string::npos);
  Series twice = example_series();
  twice.columns[2].name = "time";
  EXPECT_NE(refusal(twice).find("two columns"), std::string::npos);
  Series bare = example_series();
  bare.columns[0].units = "";
  EXPECT_NE(refusal(bare).find("units"), std::string::npos);
}

TEST(Names, AreWordsThatEveryToolTakes) {
  for (const char* good : {"t", "shear_stress", "sigma_0", "Z9"}) EXPECT_TRUE(is_valid_name(good)) << good;
  for (const char* bad : {"", "0a", "_a", "a b", "a/b", "..", "é", "a-b"}) EXPECT_FALSE(is_valid_name(bad)) << bad;
}

TEST(Metrics, MustBeFiniteNamedAndWithUnits) {
  const Metric good{"peak", 1.0, "Pa", "peak"};
  EXPECT_NO_THROW(check_metrics(std::array{good}));
  EXPECT_THROW(check_metrics(std::array{good, good}), std::invalid_argument);
  for (const Metric& bad : {Metric{"peak", std::nan(""), "Pa", ""}, Metric{"peak", 1.0, "", ""},
                            Metric{"a/b", 1.0, "Pa", ""}})
    EXPECT_THROW(check_metrics(std::array{bad}), std::invalid_argument) << bad.name;
}

TEST(Series, TellsWhichColumnsItHasAndTheirLastValues) {
  Series series = example_series(3);
  EXPECT_TRUE(series.has("time"));
  EXPECT_TRUE(series.has("shear_stress"));
  EXPECT_FALSE(series.has("velocity"));
  EXPECT_EQ(series.last("time"), series.axis.values[2]);
  EXPECT_EQ(series.last("normal_stress"), series.columns[1].values[2]);
  EXPECT_TRUE(std::isnan(series.last("velocity")));
  EXPECT_TRUE(std::isnan(example_series(0).last("time")));
}

TEST(ValueOf, IsThatOfTheMetricOfThisName) {
  const std::vector<Metric> metrics{{"peak", 3.0, "Pa", "peak"}, {"runout", 2.0, "m", "runout"}};
  EXPECT_EQ(value_of(metrics, "runout"), 2.0);
  EXPECT_EQ(value_of(metrics, "run"), std::nullopt);
}

}  // namespace
}  // namespace flowslide
