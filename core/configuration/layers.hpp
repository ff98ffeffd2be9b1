// SPDX-License-Identifier: GPL-2.0-or-later
// The layers of a configuration: files and options. A later layer replaces values of an earlier one, key by key.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "configuration/entry.hpp"

namespace flowslide {

/// One value from the command line. It is read as TOML, or as text if it is not TOML: `0.5`, `true`, `[1, 2]`,
/// `"3 kPa"` and `3 kPa` are all valid.
struct Override {
  std::string key;     ///< "sample.confining_stress"
  std::string value;   ///< as typed
  std::string option;  ///< its name in messages: "--set sample.confining_stress=3 kPa", "--seed 7"
};

/// The sources of a configuration. A later layer wins over an earlier one:
/// 1. the base: the file that the key `base` of the case file names, such as "../paper.toml"; optional;
/// 2. the case file;
/// 3. the user's file;
/// 4. the overrides, in order.
/// Within one file, the table [scale.<scale>] of the chosen scale wins over the rest of the file.
struct Layers {
  std::filesystem::path case_file;                 ///< case.toml
  std::string scale;                               ///< empty: no scale is chosen
  std::optional<std::filesystem::path> user_file;  ///< --config
  std::vector<Override> overrides;                 ///< --set, and other options that set a key
};

/// The entries of all layers.
struct LaidEntries {
  std::vector<Entry> all;         ///< in the order of the files, parents before children
  std::vector<Entry> published;   ///< entries of the case file and its base at the chosen scale
  std::vector<Entry> unselected;  ///< entries of the scales that were not chosen
  std::string base;               ///< path of the base of the case file; empty: none
};

/// Reads all layers. Throws ConfigurationError in these cases:
/// - a file cannot be read, or is not TOML (the message gives file, line and column);
/// - neither the case file nor its base has the chosen scale, or the user's file has a scale that they do not have;
/// - a file other than the case file has the key `base`;
/// - one layer has a table where another has a value.
LaidEntries lay(const Layers& layers);

}  // namespace flowslide
