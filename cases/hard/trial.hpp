// SPDX-License-Identifier: GPL-2.0-or-later
// What a scene consists of, and how each part of it is judged.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "record/series.hpp"

namespace flowslide {

/// What became of one trial, from best to worst. The last two are failures of the suite.
enum class Outcome {
  accurate,        ///< within the tolerance of what is right
  stable,          ///< not accurate, but within the bounds that theory or the order of the scheme gives
  refused,         ///< ended by an error that says what is wrong, where the trial is one that may be refused
  silently_wrong,  ///< a number outside the bounds, or none, without an error
  needless         ///< refused, although it must run
};

/// "accurate", ..., "refused needlessly".
std::string name_of(Outcome outcome);

/// What is right for one trial. All in the unit of what is measured.
struct Yardstick {
  double right = 0.0;                  ///< by theory, or of a refined run
  double accurate = 0.0;               ///< largest distance from it that counts as accurate
  double lowest = 0.0, highest = 0.0;  ///< bounds that a stable run keeps; both inclusive
  std::string refusal = {};            ///< a part of the error that may end the trial instead; empty: it must run
};

/// Accurate within `accurate`, stable within `stable`, both as shares of `right`.
Yardstick relative(double right, double accurate, double stable, const std::string& refusal = {});

/// One run of a scene.
struct SceneTrial {
  std::string setting;  ///< "dt_L = 1.5e-5 s"
  Yardstick yardstick;
  double measured = 0.0;  ///< 0 if refused
  Outcome outcome = Outcome::silently_wrong;
  std::string reason;  ///< why it was refused: the error
};

/// Measures, and judges: errors of this project (NumericalFailure, ConfigurationError, EngineError and
/// std::invalid_argument) are refusals, but one for another reason than expected counts as needless. Anything else
/// passes through: the program ends by it.
SceneTrial attempt(const std::string& setting, const Yardstick& yardstick, const std::function<double()>& measure);

/// What came out of a scene.
struct SceneRecord {
  std::vector<SceneTrial> trials;
  std::vector<Metric> metrics = {};  ///< beside the counts of outcomes
  Series details = {};               ///< a table of its own, if it has columns
};

/// How many trials ended so.
int count_of(const std::vector<SceneTrial>& trials, Outcome outcome);

/// "stable and accurate", "stable", "refused", several of them with their counts, or "SILENTLY WRONG".
std::string verdict_of(const std::vector<SceneTrial>& trials);

/// The trials as numbers: columns right, measured, accurate, lowest, highest and outcome (0 to 4, in the order of
/// Outcome); the axis counts trials from 1.
Series series_of(const std::vector<SceneTrial>& trials);

/// Rows of a Markdown table, one per trial: scene, setting, right, measured, outcome, reason.
std::string markdown_rows(const std::string& scene, const std::vector<SceneTrial>& trials);

}  // namespace flowslide
