// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "record/series.hpp"

namespace flowslide {

/// A table that a run has read from a file, kept with the result so that it can be read back when the file is gone.
struct InputTable {
  std::string name;  ///< what it is to the run, as for columns: "loading"
  std::string file;  ///< as the configuration names it
  Series rows;
};

/// The number of rows and the hash of all numbers: "3 rows (hash 0123...)". Equal texts stand for equal rows, whatever
/// the file looked like.
std::string content_of(const InputTable& table);

}  // namespace flowslide
