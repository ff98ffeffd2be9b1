// SPDX-License-Identifier: GPL-2.0-or-later
// Replicates of one run, and what can be said of them together: after its peak a sample's answer is one draw of many.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "record/result_file.hpp"

namespace flowslide {

/// The results of the replicates of one run, at least one.
using Ensemble = std::vector<Result>;
/// Ensembles by the name of their run.
using Ensembles = std::map<std::string, Ensemble>;

/// Centre and scatter of some values.
struct Statistics {
  double median = 0.0;
  double mean = 0.0;
  double lowest = 0.0, highest = 0.0;
  double deviation = 0.0;       ///< standard deviation of a draw, with n - 1; 0 for one value
  double standard_error = 0.0;  ///< of the mean, deviation/sqrt(n); 0 for one value
};

/// Throws std::invalid_argument if there are no values.
Statistics statistics_of(std::vector<double> values);

/// The values of a metric in those replicates that have it.
std::vector<double> values_of(const Ensemble& ensemble, const std::string& metric);

/// For each metric that all replicates have: "<metric>.median", ".mean", ".lowest", ".highest", ".deviation" and
/// ".standard_error".
std::map<std::string, double> summary_of(const Ensemble& ensemble);

/// Mean of `column` between two values of `abscissa` (a column or the axis), its rows joined by straight lines. Where
/// the abscissa runs back, the rows until it is passed again are left out. NaN if the series does not reach `from`.
double mean_between(const Series& series, const std::string& column, const std::string& abscissa, double from,
                    double to);

/// Median, lowest and highest of all replicates over `abscissa`, for `rows` equal intervals of the range that all of
/// them cover: each value is the mean over its interval, so that noise between rows does not count as spread. Columns
/// "<column>_median", "<column>_lowest", "<column>_highest" in the order of the series, the axis first where it is not
/// the abscissa. Empty if the replicates share no range.
Series band_over(const Ensemble& ensemble, const std::string& abscissa, int rows);

/// The same, row by row, of series that share their axis, such as profiles, as far as the shortest goes.
/// Columns that one of them lacks are left out.
Series band_of_rows(const std::vector<Series>& replicates);

}  // namespace flowslide
