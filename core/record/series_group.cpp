// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/series_group.hpp"

#include <stdexcept>
#include <utility>

namespace flowslide {
namespace {

hdf5::Dataset write_column(hdf5::Group& group, const Column& column) {
  auto dataset = group.write<double>(column.name, column.values, {column.values.size()});
  dataset.set_attribute("units", column.units);
  dataset.set_attribute("long_name", column.long_name);
  dataset.set_attribute("symbol", column.symbol);
  if (!column.sign_convention.empty()) dataset.set_attribute("sign_convention", column.sign_convention);
  return dataset;
}

Column read_column(const hdf5::Group& group, const std::string& name) {
  const auto dataset = group.dataset(name);
  Column column;
  column.name = name;
  column.symbol = dataset.text_attribute("symbol");
  column.units = dataset.text_attribute("units");
  column.long_name = dataset.text_attribute("long_name");
  if (dataset.has_attribute("sign_convention")) column.sign_convention = dataset.text_attribute("sign_convention");
  column.values = group.read<double>(name, {hdf5::Group::any});
  return column;
}

}  // namespace

void write_series(hdf5::Group& parent, const std::string& name, const Series& series) {
  series.check();
  auto group = parent.create_group(name);
  group.set_attribute("axis", series.axis.name);
  auto axis = write_column(group, series.axis);
  axis.make_scale(series.axis.name);
  for (const Column& column : series.columns) write_column(group, column).attach_scale(axis);
}

Series read_series(const hdf5::Group& parent, const std::string& name) {
  const auto group = parent.group(name);
  Series series;
  const auto axis_name = group.text_attribute("axis");
  for (const auto& member : group.names()) {
    auto column = read_column(group, member);
    if (member == axis_name) series.axis = std::move(column);
    else series.columns.push_back(std::move(column));
  }
  try {
    series.check();
  } catch (const std::invalid_argument& error) {
    throw CorruptFileError(group.label() + ": " + error.what());
  }
  return series;
}

void write_metrics(hdf5::Group& parent, const std::string& name, std::span<const Metric> metrics) {
  check_metrics(metrics);
  auto group = parent.create_group(name);
  for (const Metric& metric : metrics) {
    auto dataset = group.write(metric.name, metric.value);
    dataset.set_attribute("units", metric.units);
    dataset.set_attribute("long_name", metric.long_name);
  }
}

std::vector<Metric> read_metrics(const hdf5::Group& parent, const std::string& name) {
  const auto group = parent.group(name);
  std::vector<Metric> metrics;
  for (const auto& member : group.names()) {
    const auto dataset = group.dataset(member);
    metrics.push_back({member, group.read_number(member), dataset.text_attribute("units"),
                       dataset.text_attribute("long_name")});
  }
  return metrics;
}

}  // namespace flowslide
