// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/ensemble.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

namespace flowslide {
namespace {

/// A column over an increasing abscissa, and its integral by the trapezoidal rule.
class Curve {
 public:
  Curve(const Series& series, const std::string& column, const std::string& abscissa) {
    const std::vector<double>& at = series.column(abscissa).values;
    const std::vector<double>& value = series.column(column).values;
    for (std::size_t row = 0; row < at.size(); ++row) {
      if (!at_.empty() && at[row] <= at_.back()) continue;
      const double area = at_.empty() ? 0.0 : 0.5 * (value[row] + value_.back()) * (at[row] - at_.back());
      integral_.push_back(at_.empty() ? 0.0 : integral_.back() + area);
      at_.push_back(at[row]);
      value_.push_back(value[row]);
    }
  }

  double mean(double from, double to) const { return (integral_to(to) - integral_to(from)) / (to - from); }

 private:
  double integral_to(double end) const {
    const auto above = std::upper_bound(at_.begin(), at_.end(), end);
    if (above == at_.begin()) return (end - at_.front()) * value_.front();
    const auto row = static_cast<std::size_t>(above - at_.begin()) - 1;
    const double width = end - at_[row];
    if (above == at_.end()) return integral_[row] + width * value_[row];
    const double slope = (value_[row + 1] - value_[row]) / (at_[row + 1] - at_[row]);
    return integral_[row] + width * (value_[row] + 0.5 * slope * width);
  }

  std::vector<double> at_, value_, integral_;
};

double largest(const std::vector<double>& values) {
  return values.empty() ? -std::numeric_limits<double>::infinity() : *std::max_element(values.begin(), values.end());
}

/// The table of a sample. "loose 3f..." is a sample of the table [sample.loose] with the key 3f... (see Provenance).
std::string table_of_sample(const std::string& sample) { return sample.substr(0, sample.find(' ')); }

/// The axis and all columns of a series except the abscissa.
std::vector<Column> ordinates(const Series& series, const std::string& abscissa) {
  std::vector<Column> columns{series.axis};
  columns.insert(columns.end(), series.columns.begin(), series.columns.end());
  std::erase_if(columns, [&](const Column& column) { return column.name == abscissa; });
  return columns;
}

/// The three columns of a band for one column of the series: median, lowest and highest.
class BandColumns {
 public:
  explicit BandColumns(const Column& column) {
    for (const std::string what : {"median", "lowest", "highest"}) {
      columns_.push_back(column);
      columns_.back().values.clear();
      columns_.back().name += "_" + what;
      columns_.back().long_name = what + " " + column.long_name;
    }
  }
  void append(const std::vector<double>& replicates) {
    const Statistics all = statistics_of(replicates);
    columns_[0].values.push_back(all.median);
    columns_[1].values.push_back(all.lowest);
    columns_[2].values.push_back(all.highest);
  }
  void move_to(Series& band) {
    for (Column& column : columns_) band.columns.push_back(std::move(column));
  }

 private:
  std::vector<Column> columns_;
};

}  // namespace

Statistics statistics_of(std::vector<double> values) {
  Statistics result;
  if (values.empty() || std::any_of(values.begin(), values.end(), [](double v) { return std::isnan(v); }))
    return result;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  result.mean = result.deviation = 0.0;
  result.lowest = values.front();
  result.highest = values.back();
  result.median = 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
  for (const double value : values) result.mean += value / count;
  double squares = 0.0;
  for (const double value : values) squares += (value - result.mean) * (value - result.mean);
  if (values.size() > 1) result.deviation = std::sqrt(squares / (count - 1.0));
  result.standard_error = result.deviation / std::sqrt(count);
  return result;
}

double metric_of(const Result& result, const std::string& name) {
  return value_of(result.metrics, name).value_or(std::numeric_limits<double>::quiet_NaN());
}

std::vector<double> values_of(const Ensemble& ensemble, const std::string& metric) {
  std::vector<double> values;
  for (const Result& result : ensemble)
    if (const std::optional<double> value = value_of(result.metrics, metric)) values.push_back(*value);
  return values;
}

Statistics statistics_of(const Ensemble& ensemble, const std::string& metric) {
  return statistics_of(values_of(ensemble, metric));
}

double parameter_of(const Ensemble& ensemble, const std::string& name) {
  for (const Result& result : ensemble)
    if (const std::optional<double> value = value_of(result.parameters, name)) return *value;
  return std::numeric_limits<double>::quiet_NaN();
}

std::vector<Pair> paired(const Ensemble& first, const Ensemble& second) {
  std::vector<Pair> pairs;
  for (const Result& a : first)
    for (const Result& b : second) {
      const std::string &one = a.provenance.sample, &other = b.provenance.sample;
      const bool same_seed = a.provenance.replicate == b.provenance.replicate;
      if (same_seed && (one == other || table_of_sample(one) != table_of_sample(other))) pairs.emplace_back(&a, &b);
    }
  return pairs;
}

std::vector<std::pair<double, double>> paired_values(const std::vector<Pair>& pairs, const std::string& metric) {
  std::vector<std::pair<double, double>> values;
  for (const auto& [first, second] : pairs) values.emplace_back(metric_of(*first, metric), metric_of(*second, metric));
  return values;
}

namespace {

/// Statistics of `comparison` of both values of a metric, over the pairs in which both results have it.
template <typename Comparison>
Statistics compare(const Ensemble& first, const Ensemble& second, const std::string& metric, Comparison comparison) {
  std::vector<double> values;
  for (const auto& [a, b] : paired_values(paired(first, second), metric))
    if (!std::isnan(a) && !std::isnan(b)) values.push_back(comparison(a, b));
  return statistics_of(values);
}

}  // namespace

Statistics paired_difference(const Ensemble& first, const Ensemble& second, const std::string& metric) {
  return compare(first, second, metric, std::minus<>());
}

Statistics paired_ratio(const Ensemble& first, const Ensemble& second, const std::string& metric) {
  return compare(first, second, metric, std::divides<>());
}

std::map<std::string, double> summary_of(const Ensemble& ensemble) {
  std::map<std::string, double> summary;
  for (const Metric& metric : ensemble.front().metrics) {
    const std::vector<double> values = values_of(ensemble, metric.name);
    if (values.size() < ensemble.size()) continue;
    const Statistics all = statistics_of(values);
    summary[metric.name + ".median"] = all.median;
    summary[metric.name + ".mean"] = all.mean;
    summary[metric.name + ".lowest"] = all.lowest;
    summary[metric.name + ".highest"] = all.highest;
    summary[metric.name + ".deviation"] = all.deviation;
    summary[metric.name + ".standard_error"] = all.standard_error;
  }
  return summary;
}

double mean_between(const Series& series, const std::string& column, const std::string& abscissa, double from,
                    double to) {
  const double end = std::min(to, largest(series.column(abscissa).values));
  if (!(end > from)) return std::numeric_limits<double>::quiet_NaN();
  return Curve(series, column, abscissa).mean(from, end);
}

Series band_over(const Ensemble& ensemble, const std::string& abscissa, int rows, BandEnd end) {
  const Series& first = ensemble.front().series;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  double from = -infinite;
  std::vector<double> ends;
  for (const Result& result : ensemble) {
    const std::vector<double>& values = result.series.column(abscissa).values;
    from = values.empty() ? infinite : std::max(from, values.front());
    ends.push_back(largest(values));
  }
  std::vector<double> longest_first = ends;
  std::ranges::sort(longest_first, std::greater<>());
  const double to = end == BandEnd::all ? longest_first.back() : longest_first[ends.size() / 2];
  if (!(to > from)) rows = 0;  // columns without values
  Series band;
  band.axis = first.column(abscissa);
  band.axis.values.clear();
  const double width = (to - from) / rows;
  for (int row = 0; row < rows; ++row) band.axis.values.push_back(from + (row + 0.5) * width);
  for (const Column& column : ordinates(first, abscissa)) {
    std::vector<Curve> curves;
    for (const Result& result : ensemble) curves.emplace_back(result.series, column.name, abscissa);
    BandColumns columns(column);
    for (int row = 0; row < rows; ++row) {
      std::vector<double> values;
      values.reserve(curves.size());
      const double upper = from + (row + 1) * width;
      for (std::size_t i = 0; i < curves.size(); ++i)
        if (ends[i] >= std::min(upper, to)) values.push_back(curves[i].mean(from + row * width, upper));
      columns.append(values);
    }
    columns.move_to(band);
  }
  return band;
}

Series band_of_rows(const std::vector<Series>& replicates) {
  Series band;
  band.axis = std::min_element(replicates.begin(), replicates.end(), [](const Series& a, const Series& b) {
                return a.rows() < b.rows();
              })->axis;
  for (const Column& column : replicates.front().columns) {
    std::vector<const std::vector<double>*> all;
    for (const Series& replicate : replicates)
      for (const Column& candidate : replicate.columns)
        if (candidate.name == column.name) all.push_back(&candidate.values);
    if (all.size() < replicates.size()) continue;
    BandColumns columns(column);
    for (std::size_t row = 0; row < band.rows(); ++row) {
      std::vector<double> values;
      values.reserve(all.size());
      for (const std::vector<double>* replicate : all) values.push_back(replicate->at(row));
      columns.append(values);
    }
    columns.move_to(band);
  }
  return band;
}

}  // namespace flowslide
