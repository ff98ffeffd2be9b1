// SPDX-License-Identifier: GPL-2.0-or-later
#include "error_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace flowslide {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

SettingError setting_error(const Axis& axis, const std::string& setting, const Ensemble& runs,
                           const Ensemble& reference) {
  SettingError row{&axis, setting, {}, 0.0, "", 0.0, 0.0, 0.0, 0.0};
  for (const std::string& quantity : quantities_of(axis.scene)) {
    row.errors.push_back(error_of(runs, reference, quantity));
    const double ratio = row.errors.back().at_most();
    if (ratio <= row.error_over_spread && !row.worst.empty()) continue;
    row.error_over_spread = ratio;
    if (std::isnan(ratio)) row.error_over_spread = infinite;
    row.worst = quantity;
  }
  const auto mean = [&](const char* metric) {  // a closed-form sample has no grains and takes no steps
    return values_of(runs, metric).empty() ? 0.0 : statistics_of(runs, metric).mean;
  };
  row.grains = mean("grains");
  row.steps = mean("steps");
  row.grain_steps = mean("grain_steps");
  row.seconds = mean("processor_seconds");
  return row;
}

void mark_front(std::vector<Candidate>& by_cost) {
  double best = infinite;
  for (Candidate& candidate : by_cost) {
    candidate.on_front = candidate.error_over_spread < best;
    best = std::min(best, candidate.error_over_spread);
  }
}

}  // namespace

QuantityError error_of(const Ensemble& setting, const Ensemble& reference, const std::string& quantity) {
  constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> of_reference = values_of(reference, quantity);
  if (of_reference.size() < reference.size()) return {quantity, undefined, undefined, undefined};
  const Statistics exact = statistics_of(of_reference);
  QuantityError result{quantity, undefined, undefined, 0.0};
  std::vector<double> differences;
  for (const auto& [ours, theirs] : paired_values(paired(setting, reference), quantity))
    differences.push_back(ours - theirs);
  const double scale = std::abs(exact.mean);
  result.spread = (exact.highest - exact.lowest) / scale;
  const Statistics all = statistics_of(differences);
  result.error = std::abs(all.mean) / scale;
  if (differences.size() > 1) result.standard_error = all.standard_error / scale;
  return result;
}

std::vector<SettingError> errors_of(const std::vector<Axis>& axes, const Ensembles& runs) {
  std::vector<SettingError> rows;
  for (const Axis& axis : axes) {
    const auto reference = runs.find(axis.reference);
    if (reference == runs.end() || reference->second.size() < 2) continue;  // one seed has no spread
    for (const std::string& setting : axis.settings)
      if (const auto found = runs.find(setting); found != runs.end())
        rows.push_back(setting_error(axis, setting, found->second, reference->second));
  }
  std::sort(rows.begin(), rows.end(), [](const SettingError& a, const SettingError& b) {
    return std::tie(a.axis->scene, a.seconds, a.setting, a.axis->name) <
           std::tie(b.axis->scene, b.seconds, b.setting, b.axis->name);
  });
  return rows;
}

std::vector<Candidate> candidates_of(const std::vector<SettingError>& errors, Scene scene) {
  std::vector<Candidate> candidates;
  for (const SettingError& row : errors) {
    if (row.axis->scene != scene || !row.axis->competes) continue;
    const auto known = std::find_if(candidates.begin(), candidates.end(),
                                    [&](const Candidate& candidate) { return candidate.setting == row.setting; });
    if (known == candidates.end())
      candidates.push_back({row.setting, row.error_over_spread, row.seconds, row.grains, false});
    else
      known->error_over_spread = std::max(known->error_over_spread, row.error_over_spread);
  }
  mark_front(candidates);  // the rows, and so the candidates, are sorted by cost
  return candidates;
}

const Candidate* recommended(const std::vector<Candidate>& candidates) {
  for (const Candidate& candidate : candidates)
    if (candidate.error_over_spread <= 1.0) return &candidate;
  return nullptr;
}

}  // namespace flowslide
