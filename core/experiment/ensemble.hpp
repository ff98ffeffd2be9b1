// SPDX-License-Identifier: GPL-2.0-or-later
// Statistics over the replicates of one run. After the stress peak the response of one sample is one realization of
// many, so one run alone says little.
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
/// Run name -> its ensemble.
using Ensembles = std::map<std::string, Ensemble>;

/// Mean, median and scatter of n values. All members are NaN if there is no value.
struct Statistics {
  double median = std::numeric_limits<double>::quiet_NaN();
  double mean = median;
  double lowest = median, highest = median;
  double deviation = median;       ///< standard deviation with the divisor n - 1; 0 if n = 1
  double standard_error = median;  ///< standard error of the mean, deviation/sqrt(n); 0 if n = 1
};

/// The statistics of `values`. All members are NaN if one of the values is NaN.
Statistics statistics_of(std::vector<double> values);

/// A metric of one result; NaN if the result has no metric of this name.
double metric_of(const Result& result, const std::string& metric);

/// The values of a metric in all replicates that have it.
std::vector<double> values_of(const Ensemble& ensemble, const std::string& metric);

/// The statistics of a metric over all replicates that have it.
Statistics statistics_of(const Ensemble& ensemble, const std::string& metric);

/// A parameter that all replicates share, such as hydraulic_conductivity (see slide_parameters.hpp). NaN if they have
/// no parameter of this name.
double parameter_of(const Ensemble& ensemble, const std::string& name);

/// Two results of the same replicate, to be compared.
using Pair = std::pair<const Result*, const Result*>;

/// Pairs of results of the same replicate, in the order of the first ensemble. If both results use samples of the same
/// table [sample.<name>], they must use the same sample. Samples of two different tables may form a pair, because they
/// belong to the same replicate.
std::vector<Pair> paired(const Ensemble& first, const Ensemble& second);

/// The values of a metric in both results of each pair; NaN for a result without this metric.
std::vector<std::pair<double, double>> paired_values(const std::vector<Pair>& pairs, const std::string& metric);

/// Statistics of first - second, or of first / second, of a metric over the pairs in which both results have it. Two
/// runs on the same samples are compared in this way: what a sample adds to both runs cancels, so that the scatter
/// between samples does not hide a difference between the runs. The standard error is that of the mean over the pairs.
Statistics paired_difference(const Ensemble& first, const Ensemble& second, const std::string& metric);
Statistics paired_ratio(const Ensemble& first, const Ensemble& second, const std::string& metric);

/// Statistics of each metric that all replicates have. Names: "<metric>.median", ".mean", ".lowest", ".highest",
/// ".deviation" and ".standard_error".
std::map<std::string, double> summary_of(const Ensemble& ensemble);

/// Mean of `column` over `abscissa` (a column or the axis) from `from` to `to` or to the end of the series, by the
/// trapezoidal rule. Rows whose abscissa does not exceed all earlier values are left out. NaN if the series does not
/// extend beyond `from`.
double mean_between(const Series& series, const std::string& column, const std::string& abscissa, double from,
                    double to);

/// Where a band ends.
enum class BandEnd {
  all,   ///< at the end of the shortest replicate
  most,  ///< where half of the replicates have ended; a row is of those that reach the end of its interval
};

/// Median, lowest and highest value of the replicates over `abscissa`. The range of the band is divided into `rows`
/// equal intervals. The value of one replicate is its mean over the interval, so noise within an interval does not
/// count as scatter. Columns "<column>_median", "<column>_lowest", "<column>_highest" in the order of the series; the
/// axis comes first unless it is the abscissa. Without rows if the replicates share no range.
Series band_over(const Ensemble& ensemble, const std::string& abscissa, int rows, BandEnd end = BandEnd::all);

/// Median, lowest and highest value row by row, for series that share their axis, such as profiles. Ends with the
/// shortest series. Columns that one of the series does not have are left out.
Series band_of_rows(const std::vector<Series>& replicates);

}  // namespace flowslide
