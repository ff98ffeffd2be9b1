// SPDX-License-Identifier: GPL-2.0-or-later
// Errors and costs of settings. The error is measured against the most accurate setting of the same axis and compared
// with the scatter over seeds, the spread.
#pragma once
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "scene.hpp"

namespace flowslide {

/// A group of settings that differ by one choice, such as dt_L.
struct Axis {
  std::string name;                   ///< name of its table [axis.<name>]
  std::string title;                  ///< title in tables, "dt_L"
  Scene scene = Scene::element;
  std::string reference;              ///< the most accurate setting: name of a slide or element test
  std::vector<std::string> settings;  ///< names of the other slides or element tests
  /// Whether its settings solve the problem of the scene, so the cheapest of them may be recommended. False, for
  /// instance, for a scheme that is a different model.
  bool competes = true;
};

/// Error of one quantity over the replicates that setting and reference share. All values are relative to the mean of
/// the reference.
struct QuantityError {
  std::string quantity;
  double error = 0.0;           ///< |mean of the differences|; NaN if a replicate does not have the quantity
  double standard_error = 0.0;  ///< standard error of this mean; NaN for one replicate
  double spread = 0.0;          ///< highest - lowest value over the seeds of the reference
  /// The largest and the smallest error that the replicates do not exclude, the mean +- 2 standard errors, over the
  /// spread. NaN for one replicate. A mean alone would pass two unrelated samples, whose differences average out.
  double at_most() const { return (error + 2.0 * standard_error) / spread; }
  double at_least() const { return (error - 2.0 * standard_error) / spread; }
};

/// Errors and cost of one setting of one axis.
struct SettingError {
  const Axis* axis = nullptr;
  std::string setting;
  std::vector<QuantityError> errors;
  double error_over_spread = 0.0;  ///< largest at_most() of all quantities; infinity if one of them is NaN
  std::string worst;               ///< the quantity with this ratio
  double grains = 0.0, steps = 0.0, grain_steps = 0.0;  ///< means over the replicates; 0 for a closed-form sample
  double seconds = 0.0;            ///< mean processor time, s
  bool below_noise() const { return error_over_spread <= 1.0; }
};

/// The error of one quantity between two ensembles on the same seeds. Replicates that only one of them has are left
/// out, except in the spread.
QuantityError error_of(const Ensemble& setting, const Ensemble& reference, const std::string& quantity);

/// The errors of all settings that have results and whose reference has results, sorted by scene, then by processor
/// time. An axis whose reference has only one seed has no spread and is left out.
std::vector<SettingError> errors_of(const std::vector<Axis>& axes, const Ensembles& runs);

/// A setting of a scene with its cost, and with its largest error over all axes that compete.
struct Candidate {
  std::string setting;
  double error_over_spread = 0.0;
  double seconds = 0.0;   ///< mean processor time, s
  double grains = 0.0;    ///< number of grains
  bool on_front = false;  ///< its error is smaller than the error of every cheaper candidate
};

/// The candidates of a scene, by increasing cost.
std::vector<Candidate> candidates_of(const std::vector<SettingError>& errors, Scene scene);

/// The cheapest candidate whose error does not exceed the spread over seeds; null if there is none.
const Candidate* recommended(const std::vector<Candidate>& candidates);

}  // namespace flowslide
