// SPDX-License-Identifier: GPL-2.0-or-later
#include "speed_case.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include "app/error.hpp"
#include "order_of_accuracy.hpp"

namespace flowslide {
namespace {

double mean_of(const Ensemble& ensemble, const std::string& metric) {
  return statistics_of(values_of(ensemble, metric)).mean;
}

}  // namespace

SpeedCase::SpeedCase()
    : SlideCase({"speed_error", "Speed against error of every choice", FLOWSLIDE_VERSION, {"speed_error"}, {}},
                FLOWSLIDE_CASE_FOLDER) {}

const SlidePoint& SpeedCase::planned(const std::string& setting) const {
  return *std::find_if(slides().begin(), slides().end(), [&](const SlidePoint& s) { return s.name == setting; });
}

std::string SpeedCase::check_name(const Configuration& configuration, const std::string& key, const std::string& name,
                                  Scene scene) const {
  const auto found = std::find_if(slides().begin(), slides().end(), [&](const SlidePoint& s) { return s.name == name; });
  // On a closed-form sample there are no element tests.
  if (found == slides().end() && scene != Scene::element)
    configuration.refuse(key, "no point is called '" + name + "'", "name one of the tables [point.<name>]");
  if (found != slides().end() && scene_of(*found) != scene)
    configuration.refuse(key, "'" + name + "' is not of the scene " + name_of(scene), "name one that is");
  return name;
}

void SpeedCase::read(const Configuration& configuration) {
  SlideCase::read(configuration);
  for (const std::string& name : configuration.subtables("axis")) {
    const std::string table = "axis." + name + ".";
    Axis axis;
    axis.name = name;
    axis.title = configuration.text(table + "title");
    axis.scene = scene_named(configuration.text(table + "scene", {"element", "trigger", "pulse"}));
    axis.competes = configuration.flag(table + "competes");
    axis.reference =
        check_name(configuration, table + "reference", configuration.text(table + "reference"), axis.scene);
    for (const std::string& setting : configuration.texts(table + "settings"))
      axis.settings.push_back(check_name(configuration, table + "settings", setting, axis.scene));
    axes_.push_back(axis);
  }
  paper_grains_ = static_cast<double>(configuration.integer("liggghts.grains", Range::between(1, 1e9)));
  paper_time_step_ = configuration.quantity("liggghts.local_time_step", dimension::time, Range::positive());
  paper_rate_ = configuration.quantity("liggghts.shear_rate", dimension::rate, Range::positive());
  for (const Scene scene : {Scene::element, Scene::trigger, Scene::pulse}) {
    const std::string key = "liggghts." + name_of(scene);
    clocks_[scene] = check_name(configuration, key, configuration.text(key), scene);
  }
}

Report SpeedCase::report_on(const Ensembles& runs) const {
  Report report{errors_of(axes_, runs), {}, {}};
  for (const Scene scene : {Scene::element, Scene::trigger, Scene::pulse}) {
    report.candidates[scene] = candidates_of(report.errors, scene);
    const auto clock = runs.find(clocks_.at(scene));
    if (clock == runs.end() || values_of(clock->second, "processor_seconds").empty()) continue;
    const double duration = scene == Scene::element ? planned(clock->first).test->final_strain / paper_rate_
                                                    : mean_of(clock->second, "duration");
    report.paper[scene] = {paper_grains_, duration / paper_time_step_,
                           mean_of(clock->second, "processor_seconds") / mean_of(clock->second, "grain_steps")};
  }
  return report;
}

void SpeedCase::compare(const Ensembles& runs, std::map<std::string, double>& metrics) const {
  for (const SettingError& row : errors_of(axes_, runs)) {
    const std::string& axis = row.axis->name;
    metrics[axis + "." + row.setting + ".error_over_spread"] = row.error_over_spread;
    double& largest = metrics[axis + ".largest_error_over_spread"];
    largest = std::max(largest, row.error_over_spread);
    const Ensemble& reference = runs.at(row.axis->reference);
    if (!values_of(reference, "steps").empty())
      metrics[axis + "." + row.setting + ".steps_share"] = row.steps / mean_of(reference, "steps");
  }
  for (const Axis& axis : axes_) {
    std::vector<TimeStepError> errors;
    if (axis.scene != Scene::element || !runs.contains(axis.reference)) continue;
    for (const std::string& setting : axis.settings)
      if (runs.contains(setting))
        errors.push_back({planned(setting).settings.passing.time_step,
                          error_of(runs.at(setting), runs.at(axis.reference), "pre_peak_shear_stress").error});
    metrics[axis.name + ".order"] = order_of_accuracy(errors, planned(axis.reference).settings.passing.time_step);
  }
}

void SpeedCase::finish(const OutputFolder& output) const {
  const Ensembles runs = results_in(output.path(), points_in(output));
  const Report report = report_on(runs);
  write_report(output.path(), report);
  std::cerr << markdown(report) << '\n';
}

}  // namespace flowslide
