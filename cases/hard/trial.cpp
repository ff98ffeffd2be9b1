// SPDX-License-Identifier: GPL-2.0-or-later
#include "trial.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "configuration/error.hpp"
#include "dem/engine.hpp"
#include "sample/failure.hpp"

namespace flowslide {
namespace {

Outcome judged(const ReferenceValue& reference, double measured) {
  if (std::abs(measured - reference.right) <= reference.accurate) return Outcome::accurate;
  if (measured >= reference.lowest && measured <= reference.highest) return Outcome::stable;
  return Outcome::silently_wrong;  // includes NaN
}

/// The message of an error as one cell of a Markdown table.
std::string as_cell(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2) text.insert(at, 1, '\\');
  return text;
}

SceneTrial& refuse(SceneTrial& trial, const std::string& reason) {
  trial.reason = as_cell(reason);
  const std::string& expected = trial.reference.refusal;
  const bool allowed = !expected.empty() && reason.find(expected) != std::string::npos;
  trial.outcome = allowed ? Outcome::refused : Outcome::needless;
  return trial;
}

}  // namespace

std::string name_of(Outcome outcome) {
  constexpr std::array names{"accurate", "stable", "refused", "SILENTLY WRONG", "refused needlessly"};
  return names[static_cast<std::size_t>(outcome)];
}

ReferenceValue relative(double right, double accurate, double stable, const std::string& refusal) {
  const double size = std::abs(right);
  return {right, accurate * size, right - stable * size, right + stable * size, refusal};
}

SceneTrial attempt(const std::string& setting, const ReferenceValue& reference,
                   const std::function<double()>& measure) {
  SceneTrial trial{setting, reference, 0.0, Outcome::silently_wrong, {}};
  try {
    trial.measured = measure();
    trial.outcome = judged(reference, trial.measured);
    if (!std::isfinite(trial.measured)) trial.reason = "the number is not finite";
    if (!std::isfinite(trial.measured)) trial.measured = 0.0;  // a result accepts finite numbers only
    return trial;
  } catch (const NumericalFailure& failure) {
    return refuse(trial, failure.what());
  } catch (const ConfigurationError& error) {
    return refuse(trial, error.what());
  } catch (const EngineError& error) {
    return refuse(trial, error.what());
  } catch (const std::invalid_argument& error) {
    return refuse(trial, error.what());
  }
}

int count_of(const std::vector<SceneTrial>& trials, Outcome outcome) {
  return static_cast<int>(
      std::count_if(trials.begin(), trials.end(), [=](const SceneTrial& trial) { return trial.outcome == outcome; }));
}

std::string verdict_of(const std::vector<SceneTrial>& trials) {
  if (count_of(trials, Outcome::accurate) == static_cast<int>(trials.size())) return "stable and accurate";
  std::string verdict;
  for (const Outcome outcome :
       {Outcome::accurate, Outcome::stable, Outcome::refused, Outcome::silently_wrong, Outcome::needless}) {
    const int count = count_of(trials, outcome);
    if (count == 0) continue;
    const std::string name = outcome == Outcome::accurate ? "stable and accurate" : name_of(outcome);
    verdict += fmt::format("{}{} ({})", verdict.empty() ? "" : ", ", name, count);
  }
  return verdict;
}

Series series_of(const std::vector<SceneTrial>& trials) {
  Series series;
  series.axis = {"trial", "i", "1", "trial of the scene, from 1", "", {}};
  series.columns = {
      {"right", "", "1", "what is right, in the unit of the scene", "", {}},
      {"measured", "", "1", "what came out; 0 if refused", "", {}},
      {"accurate", "", "1", "largest distance from right that is accurate", "", {}},
      {"lowest", "", "1", "least that is stable", "", {}},
      {"highest", "", "1", "most that is stable", "", {}},
      {"outcome", "", "1", "accurate, stable, refused, silently wrong, refused needlessly: 0 to 4", "", {}}};
  double number = 0.0;
  for (const SceneTrial& trial : trials) {
    const ReferenceValue& y = trial.reference;
    const std::array row{y.right, trial.measured, y.accurate, y.lowest, y.highest, static_cast<double>(trial.outcome)};
    series.append_row(++number, row);
  }
  return series;
}

std::string markdown_rows(const std::string& scene, const std::vector<SceneTrial>& trials) {
  std::string rows;
  for (const SceneTrial& trial : trials) {
    const bool refused = trial.outcome == Outcome::refused || trial.outcome == Outcome::needless;
    rows += fmt::format("| {} | {} | {:.4g} ± {:.2g} | {} | {} | {} |\n", scene, trial.setting, trial.reference.right,
                        trial.reference.accurate, refused ? "-" : fmt::format("{:.4g}", trial.measured),
                        name_of(trial.outcome), trial.reason);
  }
  return rows;
}

}  // namespace flowslide
