// SPDX-License-Identifier: GPL-2.0-or-later
// The table [sweep] of a study: one key and the list of its values.
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// One value of a swept key.
struct SweepValue {
  std::size_t item = 0;   ///< its position in the list, from 0
  std::string text;       ///< as written, without quotes: "3 deg"
  std::string file_name;  ///< its part of the name of a run: "3deg"
  double number = 0.0;    ///< in SI units; for a text its position in the list, from 1
  double as_written = 0.0;  ///< in the unit of the sweep
};

/// A sweep. Without `key` the study has no sweep, and no values.
struct Sweep {
  std::string key;       ///< "sweep.angle" or "sweep.slope.angle"
  std::string table;     ///< "slope", "loading", "coupling", "sample", "material", ...; empty for the key `sample`
  std::string name;      ///< "angle"
  std::vector<SweepValue> values;  ///< numbers in increasing order, texts in the order of the list
  bool is_of_numbers = true;
  std::string unit;      ///< unit of as_written: "deg"; empty: bare numbers or texts
  std::string si_unit;   ///< "rad"; "1" if dimensionless

  bool exists() const { return !key.empty(); }
  /// "angle (deg)"
  std::string axis_label() const;
  /// The key that takes the value in the configuration of the run `run` with the sample `sample`.
  std::string target(const std::string& run, const std::string& sample) const;
  /// The keys of the whole configuration that this sweep replaces.
  std::vector<std::string> replaced(const Configuration& configuration, const std::string& sample) const;
};

/// Reads [sweep]. It may have one key:
/// - `sample`, whose values are names of tables [sample.<name>]; not with a closed-form sample;
/// - a key with one value of [slope], [loading] or [coupling];
/// - a key with one value of the sample: of [sample.<sample>], [material], [packing] or [preparation]. With a
///   closed-form sample these are the keys of its own table, such as [critical_state].
/// A key that two of these tables have needs the name of the table: sweep.coupling.time_step. Throws ConfigurationError
/// for any other key, with the keys that are allowed, and for a value that occurs twice.
Sweep read_sweep(const Configuration& configuration, const std::string& engine, const std::string& sample);

}  // namespace flowslide
