// SPDX-License-Identifier: GPL-2.0-or-later
// Means of a curve over fixed windows of its abscissa (time, strain, distance). They do not depend on which rows of the
// curve are kept, so metrics are made of them.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "record/result_file.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Upper end of window `number`, from 1, where the first ones are `width` wide. After 1024 windows the width doubles,
/// and after each 512 again: a window is at most 1/512 of its abscissa wide, and long records have few.
double window_end(double width, std::int64_t number);

/// Gathers the means. Kept and restored member by member, it goes on bit for bit.
struct WindowRecord {
  double width = 0.0;            ///< of the first windows, > 0
  Series means{};                ///< complete windows: the axis holds their upper ends, the columns the means
  std::int64_t number = 0;       ///< of the open window; 0 before the first point
  double begin = 0.0;            ///< where the open window begins: its lower end, or the first point of the curve
  double at = 0.0;               ///< last point of the curve
  std::vector<double> values{};  ///< there
  std::vector<double> sums{};    ///< integrals over the open window so far

  /// The next point, joined to the last by a straight line; `now` has a value for each column. Where the abscissa runs
  /// back, nothing is added until it is passed again. A point that is not finite is left out.
  void add(double where, std::span<const double> now);
  /// All windows, the last one as far as the curve goes.
  Series series() const;

 private:
  void close_up_to(double where, std::span<const double> now);
  void add_line(double where, std::span<const double> now);
  void close();
};

/// Empty windows of an axis and some columns.
WindowRecord window_record(const Column& axis, std::vector<Column> columns, double width);

/// Windows of a curve that is there as rows: of those of `columns` that it has.
Series windows_of_rows(const Series& rows, const std::string& abscissa, const std::vector<std::string>& columns,
                       double width);

/// Mean of a column of such windows between two values of the abscissa, in which each window counts with its mean. Ends
/// with the record; NaN if that does not reach beyond `from`, or lacks the column.
double mean_over(const Series& windows, const std::string& column, double from, double to);

/// Where such windows end; 0 if there are none.
double end_of(const Series& windows);

/// The windows of a result over this abscissa; empty if it has none.
const Series& windows_over(const Result& result, const std::string& abscissa);

}  // namespace flowslide
