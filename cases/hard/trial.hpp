// SPDX-License-Identifier: GPL-2.0-or-later
// The trials of a scene, and how each of them is judged.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// The outcome of one trial, from best to worst. The last two are failures.
enum class Outcome {
  accurate,        ///< the value is within the tolerance of the right value
  stable,          ///< not accurate, but within the bounds given by theory or by the order of the scheme
  refused,         ///< ended by the error that is allowed for this trial
  silently_wrong,  ///< the value is outside the bounds or not finite, without an error
  needless         ///< ended by an error that is not allowed for this trial
};

/// "accurate", ..., "refused needlessly".
std::string name_of(Outcome outcome);

/// The right value of one trial with its tolerances, in the unit of the measured value.
struct ReferenceValue {
  double right = 0.0;                  ///< the right value, by theory or from a refined run
  double accurate = 0.0;               ///< largest difference from `right` that counts as accurate
  double lowest = 0.0, highest = 0.0;  ///< bounds of a stable run, both inclusive
  std::string refusal = {};            ///< part of the message of the error that is allowed; empty: the trial must run
};

/// The tolerances as fractions of |right|: accurate within `accurate`, stable within `stable`.
ReferenceValue relative(double right, double accurate, double stable, const std::string& refusal = {});

/// One run of a scene.
struct SceneTrial {
  std::string setting;  ///< "dt_L = 1.5e-5 s"
  ReferenceValue reference;
  double measured = 0.0;  ///< 0 if refused or not finite
  Outcome outcome = Outcome::silently_wrong;
  std::string reason;  ///< message of the error, or that the value is not finite; else empty
};

/// Calls `measure` and judges its value. NumericalFailure, ConfigurationError, EngineError and std::invalid_argument
/// end the trial: with the outcome `refused` if the message contains the allowed text, otherwise `needless`. Other
/// exceptions end the program.
SceneTrial attempt(const std::string& setting, const ReferenceValue& reference, const std::function<double()>& measure);

/// The record of a scene.
struct SceneRecord {
  std::vector<SceneTrial> trials;
  std::vector<Metric> metrics = {};  ///< further metrics, beside the number of trials by outcome
  Series details = {};               ///< a further table; without columns: none
};

/// Number of trials with this outcome.
int count_of(const std::vector<SceneTrial>& trials, Outcome outcome);

/// "stable and accurate" if all trials are accurate; otherwise each outcome with its number of trials, such as
/// "stable (2), refused (1)".
std::string verdict_of(const std::vector<SceneTrial>& trials);

/// The trials as numbers. Columns: right, measured, accurate, lowest, highest and outcome (0 to 4, in the order of
/// Outcome). The axis is the number of the trial, from 1.
Series series_of(const std::vector<SceneTrial>& trials);

/// Rows of a Markdown table, one per trial: scene, setting, right, measured, outcome, reason.
std::string markdown_rows(const std::string& scene, const std::vector<SceneTrial>& trials);

}  // namespace flowslide
