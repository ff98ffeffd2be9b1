// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "coupling/adaptive_time_step.hpp"
#include "record/series.hpp"
#include "sample/dem_sample.hpp"
#include "sample/recipe.hpp"

namespace flowslide {

/// A constant-volume (undrained) simple shear test at a constant rate.
struct ShearTest {
  double shear_rate = 0.06;      ///< 1/s
  double final_strain = 0.5;     ///< gamma at the end
  int rows = 500;                ///< number of rows kept; they are closer at the start, where the peak is
  double inertial_number = 0.0;  ///< I of `shear_rate` at the initial normal stress; 0: the rate itself was chosen
  /// Empty: every step has the length dt_L. Otherwise the steps between two rows are longer where the contacts bear it.
  std::optional<AdaptiveTimeStep> adaptive = {};
  double end_normal_stress = std::numeric_limits<double>::infinity();  ///< Pa; the test ends at the measured row that
                                                                        ///< reaches this sigma
  /// Number of rows from which metrics are computed. It is fixed, so metrics do not depend on `rows`, but with
  /// adaptive steps: kept rows then change the steps between measured ones.
  static constexpr int measured_rows = 500;

  /// Number of time steps of length `time_step` (s) of the test. Rows stand at such steps, whatever steps lie between
  /// them. Throws std::invalid_argument above 1e15 steps.
  std::int64_t steps(double time_step) const;
  /// Step numbers at which rows are taken, from 0: the steps nearest to gamma = final_strain (k/rows)^2, k = 0..rows.
  /// Rows that would fall on the same step are taken once.
  std::vector<std::int64_t> row_steps(double time_step) const { return row_steps(time_step, rows); }
  /// The same for the measured rows.
  std::vector<std::int64_t> measured_steps(double time_step) const { return row_steps(time_step, measured_rows); }

 private:
  std::vector<std::int64_t> row_steps(double time_step, int count) const;
};

/// The test for a sample with this recipe and mean diameter (m). If the test has an inertial number, its shear rate is
/// computed from it. read_shear_test knows only the packing with which the search for the sample starts; call this
/// function again for the sample that was found.
ShearTest for_sample(ShearTest test, const SampleRecipe& recipe, double mean_diameter);

/// An empty record of an element test, with the columns in the order of the tables. They are shear strain; shear and
/// normal stress as passed to a slope; mean stress; inertial number; void ratio; shear and normal stress by Bagi (eq.
/// 12) and by Nicot (eq. 13), and their kinetic part (eq. 14). The axis is time.
Series shear_test_series();

/// The record of an element test.
struct ShearTestRecord {
  Series rows = shear_test_series();      ///< the rows that the test keeps
  Series measured = shear_test_series();  ///< rows at fixed strains, from which metrics are computed
};

/// Called after each row that is kept, with the number of steps done. It may throw to stop the test; a stopped test can
/// be continued.
using RowObserver = std::function<void(std::int64_t steps, const Assembly& assembly, const ShearTestRecord& record)>;

/// Shears a sample, from a linear velocity field on, and records it. The mean stress is that of the bulk with its
/// kinetic part (see bulk_mean_stress). The inertial number uses this mean stress, so it stays finite when all contacts
/// open. To continue a stopped test, pass its record as `previous` and the sample in its state at the last row. Throws
/// NumericalFailure, and std::invalid_argument if `previous` has more rows than the test.
ShearTestRecord run_shear_test(DemSample& sample, const ShearTest& test, const RowObserver& observe = {},
                               ShearTestRecord previous = {});

}  // namespace flowslide
