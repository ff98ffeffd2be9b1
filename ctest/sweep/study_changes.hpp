// SPDX-License-Identifier: GPL-2.0-or-later
// Random changes of a configuration, as --set takes them.
#pragma once
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

/// One value of a configuration: a key and its value as TOML.
struct Setting {
  std::string key;
  std::string value;

  std::string text() const { return key + "=" + value; }
};

/// The keys and values that --dry-run prints, in its order.
std::vector<Setting> settings_in(std::string_view dry_run);

/// A random engine whose numbers are the same with every compiler.
class Dice {
 public:
  explicit Dice(std::uint64_t seed) : engine_(seed) {}
  /// An integer from 0 to count - 1. Precondition: count > 0.
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(engine_() % count); }
  bool one_in(std::size_t count) { return below(count) == 0; }
  template <typename T>
  const T& one_of(const std::vector<T>& all) {
    return all[below(all.size())];
  }

 private:
  std::mt19937_64 engine_;
};

/// Another value in place of `value`: a number or a quantity times a factor, an integer next to it, the other truth, a
/// list with one member changed. Empty where there is none, such as for a name.
std::string changed_value(const std::string& value, Dice& dice);

/// From 1 to 5 of `settings` with other values. Whether they are valid together is for the program to say.
std::vector<Setting> random_changes(const std::vector<Setting>& settings, Dice& dice);

/// What a study of the user's own has on an engine: short runs, one or both schemes, one or two replicates, and,
/// mostly, a sweep over one to three values. On grains the sample is small, and no value changes it.
std::vector<Setting> random_sweep(bool of_grains, const std::string& engine, Dice& dice);

/// Whether a key stands outside the configuration of a single run of a study: a sweep, its schemes, its replicates.
bool is_of_all_runs(const std::string& key);

}  // namespace flowslide
