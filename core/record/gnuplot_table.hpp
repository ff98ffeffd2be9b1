// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "record/atomic_file.hpp"
#include "record/result_file.hpp"
#include "record/series.hpp"

namespace flowslide {

/// A series as text that gnuplot can plot:
///   # case: fig03_undrained
///   # column 1: time | t | s | time |
///   # column 2: shear_stress | tau | Pa | shear stress | positive downslope
///   0 2650
/// Numbers have the fewest digits that restore the same double.
struct Table {
  std::vector<std::pair<std::string, std::string>> header;  ///< key and value of each header line, in order
  Series series;
};

/// Writes the table, whole or not at all. Throws std::invalid_argument as Series::check, and FileError as
/// write_atomically.
void write_table(const std::filesystem::path& path, const Table& table, IfExists if_exists = IfExists::replace);

/// The table of a result. Keys of its header: case, point, figure, scale, seed, replicate, engine, configuration,
/// revision.
Table table_of(const Result& result);

/// Reads a table of write_table, bit for bit. Throws CorruptFileError with the line, and FileError if the file is
/// missing.
Table read_table(const std::filesystem::path& path);

/// `value` with the fewest digits that restore the same double, in the shorter notation: "0.1" or "1e-07".
std::string shortest(double value);

}  // namespace flowslide
