// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/series.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace flowslide {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

void check_label(const std::string& name, const std::string& units, std::set<std::string>& used) {
  if (!is_valid_name(name))
    throw std::invalid_argument(fmt::format(
        "'{}' cannot name a column or metric; use letters, digits and '_', a letter first", name));
  if (!used.insert(name).second) throw std::invalid_argument(fmt::format("two columns or metrics named '{}'", name));
  if (units.empty()) throw std::invalid_argument(fmt::format("'{}' has no units; use \"1\" if dimensionless", name));
}

void check_column(const Column& column, std::size_t rows, std::set<std::string>& used) {
  check_label(column.name, column.units, used);
  if (column.values.size() != rows)
    throw std::invalid_argument(
        fmt::format("column '{}' has {} rows, its axis {}", column.name, column.values.size(), rows));
  for (std::size_t row = 0; row < rows; ++row)
    if (!std::isfinite(column.values[row]))
      throw std::invalid_argument(
          fmt::format("column '{}' is {} in row {}; it must be finite", column.name, column.values[row], row));
}

}  // namespace

bool is_valid_name(std::string_view name) {
  if (name.empty() || !is_letter(name.front())) return false;
  for (const char c : name)
    if (!is_letter(c) && !is_digit(c) && c != '_') return false;
  return true;
}

void Series::append_row(double axis_value, std::span<const double> values) {
  if (values.size() != columns.size())
    throw std::invalid_argument(fmt::format("a row of {} values for {} columns", values.size(), columns.size()));
  axis.values.push_back(axis_value);
  for (std::size_t i = 0; i < columns.size(); ++i) columns[i].values.push_back(values[i]);
}

const Column& Series::column(std::string_view name) const {
  if (name == axis.name) return axis;
  std::string known = axis.name;
  for (const Column& column : columns) {
    if (column.name == name) return column;
    known += ", " + column.name;
  }
  throw std::out_of_range(fmt::format("no column '{}'; there are {}", name, known));
}

bool Series::has(std::string_view name) const {
  return name == axis.name ||
         std::any_of(columns.begin(), columns.end(), [&](const Column& column) { return column.name == name; });
}

double Series::last(std::string_view name) const {
  return rows() > 0 && has(name) ? column(name).values.back() : std::numeric_limits<double>::quiet_NaN();
}

void Series::check() const {
  std::set<std::string> used;
  check_column(axis, rows(), used);
  for (const Column& column : columns) check_column(column, rows(), used);
}

std::optional<double> value_of(const std::vector<Metric>& metrics, std::string_view name) {
  for (const Metric& metric : metrics)
    if (metric.name == name) return metric.value;
  return std::nullopt;
}

void check_metrics(std::span<const Metric> metrics) {
  std::set<std::string> used;
  for (const Metric& metric : metrics) {
    check_label(metric.name, metric.units, used);
    if (!std::isfinite(metric.value))
      throw std::invalid_argument(fmt::format("metric '{}' is {}; it must be finite", metric.name, metric.value));
  }
}

}  // namespace flowslide
