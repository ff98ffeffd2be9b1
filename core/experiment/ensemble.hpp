// SPDX-License-Identifier: GPL-2.0-or-later
// Replicates of one run, and what can be said of them together: after its peak a sample's answer is one draw of many.
#pragma once
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "record/result_file.hpp"

namespace flowslide {

/// The results of the replicates of one run, at least one.
using Ensemble = std::vector<Result>;
/// Ensembles by the name of their run.
using Ensembles = std::map<std::string, Ensemble>;

/// Centre and scatter of some values; not numbers where there are none.
struct Statistics {
  double median = std::numeric_limits<double>::quiet_NaN();
  double mean = median;
  double lowest = median, highest = median;
  double deviation = median;       ///< standard deviation of one value, with n - 1; 0 for a single one
  double standard_error = median;  ///< of the mean, deviation/sqrt(n); 0 for a single value
};

/// Not numbers, too, if one of the values is none.
Statistics statistics_of(std::vector<double> values);

/// A metric of one result; NaN if it has none of that name.
double metric_of(const Result& result, const std::string& metric);

/// The values of a metric in those replicates that have it.
std::vector<double> values_of(const Ensemble& ensemble, const std::string& metric);

/// Of a metric in those replicates that have it.
Statistics statistics_of(const Ensemble& ensemble, const std::string& metric);

/// A parameter of the runs, such as hydraulic_conductivity (see slide_point.hpp), which all replicates share. NaN if
/// they have none of that name.
double parameter_of(const Ensemble& ensemble, const std::string& name);

/// Two results on one sample.
using Pair = std::pair<const Result*, const Result*>;

/// Pairs of results of the same replicate, in the order of the first ensemble. Results on two samples of one table
/// [sample.<name>] make no pair; those on samples of two tables do, as their seeds are of one number.
std::vector<Pair> paired(const Ensemble& first, const Ensemble& second);

/// The values of a metric in both results of each pair; not a number where one lacks it.
std::vector<std::pair<double, double>> paired_values(const std::vector<Pair>& pairs, const std::string& metric);

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
/// the abscissa. Without rows if the replicates share no range.
Series band_over(const Ensemble& ensemble, const std::string& abscissa, int rows);

/// The same, row by row, of series that share their axis, such as profiles, as far as the shortest goes.
/// Columns that one of them lacks are left out.
Series band_of_rows(const std::vector<Series>& replicates);

}  // namespace flowslide
