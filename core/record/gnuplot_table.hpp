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

/// Key and value of each header line of a table, in order.
using TableHeader = std::vector<std::pair<std::string, std::string>>;

/// A series as a text file <name>.dat. The first line has the names of the columns, for gnuplot's column("time"),
/// numpy.genfromtxt(names=True) and pandas.read_csv(sep=r"\s+", comment="#"). Comments follow, then the rows:
///   time shear_stress
///   # case: fig03_undrained
///   # column 1: time | t | s | time |
///   # column 2: shear_stress | tau | Pa | shear stress | positive downslope
///   0 2650
/// Numbers have the fewest digits that restore the same double.
struct Table {
  TableHeader header;
  Series series;
};

/// The lines of a table above its rows, for tables that are no Series, such as those with a column of text. Each row
/// below them has one word or number per column, with blanks between. The values of `columns` are not read. The unit of
/// a text is "text". Throws std::invalid_argument for a name that is_valid_name refuses.
std::string table_head(const std::vector<Column>& columns, const TableHeader& header = {});

/// Writes the table, whole or not at all. Throws std::invalid_argument as Series::check, and FileError as
/// write_atomically.
void write_table(const std::filesystem::path& path, const Table& table, IfExists if_exists = IfExists::replace);

/// The table of a result. Keys of its header: case, point, figure, scale, seed, replicate, engine, configuration,
/// revision.
Table table_of(const Result& result);

/// Reads a table of write_table, bit for bit. Throws CorruptFileError with the line, and FileError if the file is
/// missing. A table whose first line is a comment, as of earlier versions, is refused.
Table read_table(const std::filesystem::path& path);

/// `value` with the fewest digits that restore the same double, in the shorter notation: "0.1" or "1e-07".
std::string shortest(double value);

}  // namespace flowslide
