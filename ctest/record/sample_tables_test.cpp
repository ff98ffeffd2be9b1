// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_tables.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "grains/measures.hpp"
#include "record/gnuplot_table.hpp"
#include "support/touching_lattice.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(SampleTables, HoldSlicesDistancesAndContacts) {
  const TemporaryFolder folder;
  const Assembly lattice = touching_lattice(7, 8);
  write_sample_tables(folder.path(), "sample", lattice);
  for (const char* axis : {"x", "y", "z"}) {
    const Series slices = read_table(folder / (std::string("sample_slices_") + axis + ".dat")).series;
    EXPECT_EQ(slices.rows(), axis[0] == 'z' ? 8u : 7u);
    for (std::size_t i = 0; i < slices.rows(); ++i) {
      EXPECT_NEAR(slices.column("void_ratio").values[i], void_ratio(lattice), 0.01);  // a layer each
      EXPECT_LT(slices.column("lowest_random").values[i], slices.column("void_ratio").values[i]);
      EXPECT_GT(slices.column("highest_random").values[i], slices.column("void_ratio").values[i]);
    }
    EXPECT_NEAR(slices.axis.values.front() + slices.axis.values.back(), 1.0, 1e-12);
  }
  const Series distances = read_table(folder / "sample_distances.dat").series;
  EXPECT_EQ(distances.rows(), 60u);
  // Neighbours of a simple cubic lattice at 0.998 and sqrt(2): none between.
  EXPECT_EQ(distances.column("density").values[24], 0.0);
  EXPECT_GT(distances.column("density").values[19], 3.0);
  const Series contacts = read_table(folder / "sample_contacts.dat").series;
  const std::vector<double>& shares = contacts.column("share").values;
  EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1.0, 1e-12);
  EXPECT_GT(shares.at(6), 0.9);
}

}  // namespace
}  // namespace flowslide
