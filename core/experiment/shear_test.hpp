// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "record/series.hpp"
#include "sample/dem_sample.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// A constant-volume (undrained) simple shear test at a constant rate.
struct ShearTest {
  double shear_rate = 0.06;      ///< 1/s
  double final_strain = 0.5;     ///< gamma
  int rows = 500;                ///< that are kept; closer together at the start, where the peak is
  double inertial_number = 0.0;  ///< I of that rate at the initial normal stress; 0: the rate was chosen as such
  /// Rows that metrics are made of, whatever rows are kept.
  static constexpr int measured_rows = 500;

  /// Steps in all, with a time step in s. Throws std::invalid_argument for more than can be counted.
  std::int64_t steps(double time_step) const;
  /// Steps at which the rows are taken: gamma = final_strain (k/rows)^2, rounded, each at least one step after the
  /// other, from 0 on.
  std::vector<std::int64_t> row_steps(double time_step) const { return row_steps(time_step, rows); }
  /// The same of the measured rows.
  std::vector<std::int64_t> measured_steps(double time_step) const { return row_steps(time_step, measured_rows); }

 private:
  std::vector<std::int64_t> row_steps(double time_step, int count) const;
};

/// The test of a sample of that recipe with grains of that mean diameter (m): an inertial number stays, and the shear
/// rate follows from it. What is read has the packing that the search for the sample begins with.
ShearTest for_sample(ShearTest test, const SampleRecipe& recipe, double mean_diameter);

/// Columns of an element test in the order of the tables: shear strain, the stress that a slope is told, mean stress,
/// inertial number, void ratio, and shear and normal stress by Bagi, by Nicot and of the kinetic part.
Series shear_test_series();

/// The record of an element test.
struct ShearTestRecord {
  Series rows = shear_test_series();      ///< as many as the test keeps
  Series measured = shear_test_series();  ///< at fixed strains: what metrics are made of
};

/// What is told after each row that is kept; it may end the test by an exception, to be gone on with.
using RowObserver = std::function<void(std::int64_t steps, const Assembly& assembly, const ShearTestRecord& record)>;

/// Shears a sample from a linear velocity field and records it. The mean stress is that of the bulk (see bulk_stress)
/// with the kinetic part, and the inertial number is built on it, so that it stays finite when no contact is left.
/// `so_far` is the record of a test that is gone on with, by a sample that stands at the last of its rows.
/// Throws NumericalFailure.
ShearTestRecord run_shear_test(DemSample& sample, const ShearTest& test, const RowObserver& observe = {},
                                   ShearTestRecord so_far = {});

}  // namespace flowslide
