// SPDX-License-Identifier: GPL-2.0-or-later
// Errors of settings against the most accurate one of their axis, beside the spread over seeds, and what they cost.
#pragma once
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "scene.hpp"

namespace flowslide {

/// Settings that differ by one choice, such as dt_L.
struct Axis {
  std::string name;                   ///< of its table [axis.<name>]
  std::string title;                  ///< for people, "dt_L"
  Scene scene = Scene::element;
  std::string reference;              ///< the most accurate setting: the name of its slide or test
  std::vector<std::string> settings;  ///< the others
  /// Whether its settings answer the question of the scene itself, so that the cheapest of them may be recommended; not
  /// so, say, those of a scheme that is another model.
  bool competes = true;
};

/// Error of one quantity, over the replicates that setting and reference share, all relative to the reference's mean.
struct QuantityError {
  std::string quantity;
  double error = 0.0;           ///< |mean of the differences|; NaN if a replicate lacks the quantity
  double standard_error = 0.0;  ///< of that mean; NaN for one replicate
  double spread = 0.0;          ///< highest less lowest value of the reference's seeds
  double ratio() const { return error / spread; }
};

/// One setting of one axis, or the reference of a scene itself.
struct SettingError {
  const Axis* axis = nullptr;
  std::string setting;
  std::vector<QuantityError> errors;
  double error_over_spread = 0.0;  ///< the largest ratio; infinity if a quantity is missing
  std::string worst;               ///< the quantity that has it
  double grains = 0.0, steps = 0.0, grain_steps = 0.0;  ///< means over the replicates; 0 without grains
  double seconds = 0.0;            ///< processor time, mean
  bool below_noise() const { return error_over_spread <= 1.0; }
};

/// Of two ensembles on the same seeds; replicates that only one has do not count, but for the spread.
QuantityError error_of(const Ensemble& setting, const Ensemble& reference, const std::string& quantity);

/// The settings of all axes that have been run together with their references, by scene, then cost in processor time.
/// An axis whose reference has been run on one seed alone has no spread, and is left out.
std::vector<SettingError> errors_of(const std::vector<Axis>& axes, const Ensembles& runs);

/// A setting of a scene with the largest of its errors on any axis that competes, and its cost.
struct Candidate {
  std::string setting;
  double error_over_spread = 0.0;
  double seconds = 0.0;
  double grains = 0.0;
  bool on_front = false;  ///< no other is as cheap and as accurate
};

/// The candidates of a scene by cost.
std::vector<Candidate> candidates_of(const std::vector<SettingError>& errors, Scene scene);

/// The cheapest candidate whose error is at most the spread over seeds; null if there is none.
const Candidate* recommended(const std::vector<Candidate>& candidates);

}  // namespace flowslide
