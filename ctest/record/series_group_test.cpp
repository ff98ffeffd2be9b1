// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/series_group.hpp"

#include <gtest/gtest.h>
#include <hdf5_hl.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "example.hpp"
#include "same_bits.hpp"

namespace flowslide {
namespace {

TEST(SeriesGroup, GivesBackEveryBitInOrder) {
  for (const std::size_t rows : {std::size_t{0}, std::size_t{1}, std::size_t{50}}) {
    auto file = hdf5::File::create("test");
    const auto series = example_series(rows);
    write_series(file.root(), "series", series);
    expect_same_bits(read_series(hdf5::File::open(file.image(), "test").root(), "series"), series);
  }
}

TEST(SeriesGroup, SharesOneAxisAsADimensionScale) {
  auto file = hdf5::File::create("test");
  write_series(file.root(), "series", example_series());
  const auto image = hdf5::File::open(file.image(), "test");
  const auto group = image.root().group("series");
  const auto axis = group.dataset("time");
  EXPECT_GT(H5DSis_scale(axis.id()), 0);
  for (const char* name : {"shear_stress", "normal_stress", "inertial_number"}) {
    const auto column = group.dataset(name);
    EXPECT_EQ(H5DSis_scale(column.id()), 0);
    EXPECT_GT(H5DSis_attached(column.id(), axis.id(), 0), 0) << name;
    EXPECT_EQ(column.text_attribute("units"), example_series().column(name).units);
    EXPECT_EQ(column.text_attribute("long_name"), example_series().column(name).long_name);
    EXPECT_EQ(column.text_attribute("symbol"), example_series().column(name).symbol);
  }
  EXPECT_EQ(group.dataset("normal_stress").text_attribute("sign_convention"), "compression positive");
  EXPECT_FALSE(group.dataset("inertial_number").has_attribute("sign_convention"));
}

TEST(SeriesGroup, RefusesNumbersThatAreNone) {
  auto file = hdf5::File::create("test");
  auto series = example_series();
  series.columns[1].values[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_series(file.root(), "series", series), std::invalid_argument);
  EXPECT_FALSE(file.root().has("series"));
  const std::vector<Metric> metrics{{"peak", std::numeric_limits<double>::infinity(), "Pa", ""}};
  EXPECT_THROW(write_metrics(file.root(), "metrics", metrics), std::invalid_argument);
  EXPECT_FALSE(file.root().has("metrics"));
}

TEST(SeriesGroup, RefusesToReadColumnsOfDifferentLength) {
  auto file = hdf5::File::create("test");
  write_series(file.root(), "series", example_series());
  auto group = file.root().group("series");
  auto extra = group.write<double>("extra", std::vector{1.0, 2.0}, {2});
  for (const char* name : {"units", "long_name", "symbol"}) extra.set_attribute(name, "1");
  EXPECT_THROW(read_series(file.root(), "series"), CorruptFileError);
  EXPECT_THROW(read_series(file.root(), "missing"), CorruptFileError);
}

TEST(SeriesGroup, GivesBackMetricsInOrder) {
  auto file = hdf5::File::create("test");
  const std::vector<Metric> metrics{{"z", 0.1, "Pa", "last"}, {"a", -0.0, "1", ""}};
  write_metrics(file.root(), "metrics", metrics);
  const auto read = read_metrics(file.root(), "metrics");
  ASSERT_EQ(read.size(), 2);
  EXPECT_EQ(read[0].name, "z");
  EXPECT_EQ(read[0].value, 0.1);
  EXPECT_EQ(read[0].units, "Pa");
  EXPECT_EQ(read[0].long_name, "last");
  EXPECT_EQ(read[1].name, "a");
  EXPECT_TRUE(std::signbit(read[1].value));
}

}  // namespace
}  // namespace flowslide
