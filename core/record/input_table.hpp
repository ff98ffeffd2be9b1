// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "record/series.hpp"

namespace flowslide {

/// A table that a run has read from a file. The result keeps it, because the file may be lost later.
struct InputTable {
  std::string name;  ///< its use in the run: "loading"; letters as for columns
  std::string file;  ///< path as given in the configuration
  Series rows;
};

/// The number of rows and the hash of all numbers: "3 rows (hash 0123...)". Equal texts mean equal rows; the format of
/// the file does not matter.
std::string content_of(const InputTable& table);

}  // namespace flowslide
