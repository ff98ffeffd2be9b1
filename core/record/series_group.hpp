// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "record/hdf5.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Writes a series as the new group `name`: one dataset per column, attributes units, long_name, symbol and (unless
/// empty) sign_convention; the axis is a dimension scale attached to each column.
/// Throws std::invalid_argument if Series::check does.
void write_series(hdf5::Group& parent, const std::string& name, const Series& series);

/// Reads it back, columns in their order. Throws CorruptFileError if it is not one.
Series read_series(const hdf5::Group& parent, const std::string& name);

/// Writes metrics as the new group `name`: one scalar each, attributes units and long_name.
/// Throws std::invalid_argument if check_metrics does.
void write_metrics(hdf5::Group& parent, const std::string& name, std::span<const Metric> metrics);
std::vector<Metric> read_metrics(const hdf5::Group& parent, const std::string& name);

}  // namespace flowslide
