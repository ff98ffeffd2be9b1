// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flowslide {
namespace {

constexpr std::int64_t narrow_windows = 1024, windows_per_doubling = 512;

}  // namespace

double window_end(double width, std::int64_t number) {
  if (number <= narrow_windows) return width * static_cast<double>(number);
  const std::int64_t level = (number - narrow_windows) / windows_per_doubling;
  const std::int64_t beyond = (number - narrow_windows) % windows_per_doubling;
  return std::ldexp(width * static_cast<double>(narrow_windows + 2 * beyond), static_cast<int>(level));
}

void WindowRecord::add(double where, std::span<const double> now) {
  if (!std::isfinite(where)) return;
  if (number == 0) {
    number = 1;
    while (window_end(width, number) <= where) ++number;
    begin = at = where;
    values.assign(now.begin(), now.end());
    sums.assign(now.size(), 0.0);
    return;
  }
  if (!(where > at)) return;
  if (window_end(width, number) <= where) close_up_to(where, now);
  add_line(where, now);
}

void WindowRecord::close_up_to(double where, std::span<const double> now) {
  const double start = at;
  const std::vector<double> before = values;
  std::vector<double> edge(now.size());
  for (double end = window_end(width, number); end <= where; end = window_end(width, number)) {
    const double share = (end - start) / (where - start);
    for (std::size_t i = 0; i < edge.size(); ++i) edge[i] = before[i] + share * (now[i] - before[i]);
    add_line(end, edge);
    close();
  }
}

void WindowRecord::add_line(double where, std::span<const double> now) {
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += 0.5 * (values[i] + now[i]) * (where - at);
  at = where;
  values.assign(now.begin(), now.end());
}

void WindowRecord::close() {
  for (double& sum : sums) sum /= at - begin;
  means.append_row(at, sums);
  std::fill(sums.begin(), sums.end(), 0.0);
  begin = at;
  ++number;
}

Series WindowRecord::series() const {
  if (number == 0 || !(at > begin)) return means;
  WindowRecord all = *this;
  all.close();
  return std::move(all.means);
}

WindowRecord window_record(const Column& axis, std::vector<Column> columns, double width) {
  WindowRecord record{.width = width};
  record.means.axis = axis;
  record.means.columns = std::move(columns);
  record.means.axis.values.clear();
  for (Column& column : record.means.columns) column.values.clear();
  return record;
}

Series windows_of_rows(const Series& rows, const std::string& abscissa, const std::vector<std::string>& columns,
                       double width) {
  std::vector<Column> found;
  for (const std::string& name : columns)
    if (name != abscissa && rows.has(name)) found.push_back(rows.column(name));
  WindowRecord record = window_record(rows.column(abscissa), found, width);
  std::vector<double> values(found.size());
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    for (std::size_t i = 0; i < found.size(); ++i) values[i] = found[i].values[row];
    record.add(rows.column(abscissa).values[row], values);
  }
  return record.series();
}

double end_of(const Series& windows) { return windows.rows() == 0 ? 0.0 : windows.axis.values.back(); }

double mean_over(const Series& windows, const std::string& column, double from, double to) {
  from = std::max(from, 0.0);
  const double end = std::min(to, end_of(windows));
  if (!(end > from) || !windows.has(column)) return std::numeric_limits<double>::quiet_NaN();
  const std::vector<double>&ends = windows.axis.values, &means = windows.column(column).values;
  auto window = static_cast<std::size_t>(std::upper_bound(ends.begin(), ends.end(), from) - ends.begin());
  double sum = 0.0;
  for (double lower = from; lower < end; ++window) {
    const double upper = std::min(ends[window], end);
    sum += means[window] * (upper - lower);
    lower = upper;
  }
  return sum / (end - from);
}

const Series& windows_over(const Result& result, const std::string& abscissa) {
  static const Series none;
  const auto found = std::find_if(result.windows.begin(), result.windows.end(),
                                  [&](const Series& windows) { return windows.axis.name == abscissa; });
  return found == result.windows.end() ? none : *found;
}

}  // namespace flowslide
