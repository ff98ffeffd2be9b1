// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "record/hdf5.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Writes a series as the new group `name`, one dataset of shape (rows) per column. Attributes: units, long_name,
/// symbol, and sign_convention unless it is empty. The axis is a dimension scale attached to each column. Throws
/// std::invalid_argument as Series::check.
void write_series(hdf5::Group& parent, const std::string& name, const Series& series);

/// Reads a series back, columns in their order. Throws CorruptFileError if the group is not a valid series.
Series read_series(const hdf5::Group& parent, const std::string& name);

/// Writes metrics as the new group `name`, one scalar dataset each with the attributes units and long_name. Throws
/// std::invalid_argument as check_metrics.
void write_metrics(hdf5::Group& parent, const std::string& name, std::span<const Metric> metrics);
std::vector<Metric> read_metrics(const hdf5::Group& parent, const std::string& name);

}  // namespace flowslide
