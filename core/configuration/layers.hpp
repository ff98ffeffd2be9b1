// SPDX-License-Identifier: GPL-2.0-or-later
// The layers of a configuration: files and options, laid over each other key by key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "configuration/entry.hpp"

namespace flowslide {

/// One value from the command line. The value is read as TOML and, if it is none, as text: `0.5`, `true`, `[1, 2]`,
/// `"3 kPa"` and `3 kPa` all work.
struct Override {
  std::string key;     ///< "sample.confining_stress"
  std::string value;   ///< as typed
  std::string option;  ///< what to call it in a message: "--set sample.confining_stress=3 kPa", "--seed 7"
};

/// Where a configuration comes from. A later layer wins over an earlier one:
/// 1. the file that the key `base` of the case file names, such as "../paper.toml", if it names one;
/// 2. the case file;
/// 3. the user's file;
/// 4. the overrides, in order.
/// Within a file, its table [scale.<scale>] wins over the rest of the file.
struct Layers {
  std::filesystem::path case_file;                 ///< case.toml
  std::string scale;                               ///< empty: no scale is asked for
  std::optional<std::filesystem::path> user_file;  ///< --config
  std::vector<Override> overrides;                 ///< --set and the options that stand for a key
};

/// The entries of all layers.
struct LaidEntries {
  std::vector<Entry> all;         ///< in the order of the files, parents before children
  std::vector<Entry> published;   ///< those of the case file and its base at the scale
  std::vector<Entry> unselected;  ///< of the scales that were not asked for
  std::string base;               ///< the file below the case file; empty when it has none
};

/// Reads all layers. Throws ConfigurationError when a file cannot be read, is not TOML (file, line and column), has no
/// such scale, has a base where it may not have one, or puts a table where another layer has a value or the other way
/// round.
LaidEntries lay(const Layers& layers);

}  // namespace flowslide
