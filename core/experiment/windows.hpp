// SPDX-License-Identifier: GPL-2.0-or-later
// Means of a curve over fixed windows of its abscissa (time, strain or displacement). They do not depend on which rows
// of the curve are kept. Metrics are therefore computed from them.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "record/result_file.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Upper end of window `number` (from 1). The first windows have the width `width`. The width doubles after 1024
/// windows and then after every 512 windows. A wider window is at most 1/512 of its abscissa wide, and long records
/// have few windows.
double window_end(double width, std::int64_t number);

/// Gathers the means. A record whose members are all restored continues bit for bit.
struct WindowRecord {
  double width = 0.0;            ///< width of the first windows, > 0
  Series means{};                ///< complete windows: the axis holds their upper ends, the columns the means
  std::int64_t number = 0;       ///< number of the open window; 0 before the first point
  double begin = 0.0;            ///< start of the open window: its lower end, or the first point of the curve
  double at = 0.0;               ///< abscissa of the last point
  std::vector<double> values{};  ///< columns at the last point
  std::vector<double> sums{};    ///< integrals over the open window so far

  /// Adds a point at the abscissa `where`; `now` has one value for each column. A straight line joins the point to the
  /// last one. A point whose abscissa is not finite, or not above the last one, is left out.
  void add(double where, std::span<const double> now);
  /// All windows. The last one ends at the last point.
  Series series() const;

 private:
  void close_up_to(double where, std::span<const double> now);
  void add_line(double where, std::span<const double> now);
  void close();
};

/// A record without points, for this axis and these columns.
WindowRecord window_record(const Column& axis, std::vector<Column> columns, double width);

/// Windows of a curve that is given as rows, for those of `columns` that it has.
Series windows_of_rows(const Series& rows, const std::string& abscissa, const std::vector<std::string>& columns,
                       double width);

/// Mean of a column from `from` (at least 0) to `to`, or to the end of the windows. The column counts as constant
/// within each window. NaN if the windows end at or before `from`, or if there is no such column.
double mean_over(const Series& windows, const std::string& column, double from, double to);

/// Upper end of the last window; 0 if there are no windows.
double end_of(const Series& windows);

/// The windows of a result over this abscissa; an empty series if it has none.
const Series& windows_over(const Result& result, const std::string& abscissa);

}  // namespace flowslide
