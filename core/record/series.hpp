// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// One quantity along the axis of a series.
struct Column {
  std::string name;             ///< name of the dataset, such as "shear_stress": letters, digits, '_', a letter first
  std::string symbol;           ///< as in the paper, such as "tau"
  std::string units;            ///< SI, such as "Pa"; "1" if dimensionless
  std::string long_name;        ///< name for readers, such as "shear stress"
  std::string sign_convention;  ///< such as "compression positive"; empty if the quantity has no sign convention
  std::vector<double> values{};  ///< shape (rows)
};

/// Columns that share one axis, usually time in s. All have the same number of rows.
struct Series {
  Column axis{"time", "t", "s", "time", "", {}};
  std::vector<Column> columns;

  std::size_t rows() const { return axis.values.size(); }
  /// Appends one value to the axis and to each column, in their order. Throws std::invalid_argument if the number of
  /// values is not the number of columns; then nothing is appended.
  void append_row(double axis_value, std::span<const double> values);
  /// The column or axis of this name. Throws std::out_of_range; the message lists the existing names.
  const Column& column(std::string_view name) const;
  /// Whether a column or the axis has this name.
  bool has(std::string_view name) const;
  /// The last value of the column; NaN without such a column or without rows.
  double last(std::string_view name) const;
  /// Throws std::invalid_argument if lengths differ, if a name is empty, malformed or used twice, if units are missing,
  /// or if a value is not finite; the message then gives column and row.
  void check() const;
};

/// One number that summarizes a run, such as the peak of the shear stress. A metric without a value is left out.
struct Metric {
  std::string name;       ///< letters as for columns
  double value = 0.0;     ///< finite
  std::string units;      ///< SI; "1" if dimensionless
  std::string long_name;  ///< name for readers
};

/// The value of the metric `name`; empty without one.
std::optional<double> value_of(const std::vector<Metric>& metrics, std::string_view name);

/// True if `name` can name a column, a metric or a profile.
bool is_valid_name(std::string_view name);

/// Throws std::invalid_argument if a name is malformed or used twice, if units are missing, or if a value is not
/// finite.
void check_metrics(std::span<const Metric> metrics);

}  // namespace flowslide
