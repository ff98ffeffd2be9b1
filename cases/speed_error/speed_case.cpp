// SPDX-License-Identifier: GPL-2.0-or-later
#include "speed_case.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace flowslide {
std::unique_ptr<Case> make_case() { return std::make_unique<SpeedCase>(); }

SpeedCase::SpeedCase()
    : SlideCase({"speed_error", "Speed against error of every choice", FLOWSLIDE_VERSION, {"speed_error"}, {}}) {}

const SlidePoint* SpeedCase::planned(const std::string& setting) const {
  const auto found =
      std::find_if(slides().begin(), slides().end(), [&](const SlidePoint& s) { return s.name == setting; });
  return found == slides().end() ? nullptr : &*found;
}

const SlidePoint* SpeedCase::find(const Configuration& configuration, const std::string& key) const {
  return planned(configuration.text(key, configuration.subtables("point")));
}

void SpeedCase::read_axis(const Configuration& configuration, const std::string& name) {
  const std::string table = "axis." + name + ".";
  Axis axis;
  axis.name = name;
  axis.title = configuration.text(table + "title");
  if (configuration.has(table + "competes")) axis.competes = configuration.flag(table + "competes");
  axis.settings = configuration.texts(table + "settings", configuration.subtables("point"));
  const SlidePoint* reference = find(configuration, table + "reference");
  if (reference == nullptr) return;  // an element test, which a closed-form sample does not have
  axis.reference = reference->name;
  axis.scene = scene_of(*reference);
  for (const std::string& setting : axis.settings)
    if (const SlidePoint* own = planned(setting); own != nullptr && scene_of(*own) != axis.scene)
      configuration.refuse(table + "settings", "'" + setting + "' is not of the scene of the reference, " +
                           name_of(axis.scene), "compare settings of one scene");
  axes_.push_back(axis);
}

void SpeedCase::read(const Configuration& configuration) {
  SlideCase::read(configuration);
  for (const std::string& name : configuration.subtables("axis")) read_axis(configuration, name);
  paper_grains_ = static_cast<double>(configuration.integer("liggghts.grains", Range::between(1, 1e9)));
  paper_time_step_ = configuration.quantity("liggghts.local_time_step", dimension::time, Range::positive());
  paper_rate_ = configuration.quantity("liggghts.shear_rate", dimension::rate, Range::positive());
  for (const Scene scene : all_scenes) {
    const std::string key = "liggghts." + name_of(scene);
    const SlidePoint* clock = find(configuration, key);
    if (clock != nullptr && scene_of(*clock) == scene)
      clocks_[scene] = clock->name;  // the user may have changed its loading, and so its scene
  }
}

Report SpeedCase::report_on(const Ensembles& runs) const {
  Report report{errors_of(axes_, runs), {}, {}};
  for (const Scene scene : all_scenes) {
    report.candidates[scene] = candidates_of(report.errors, scene);
    const auto name = clocks_.find(scene);
    const auto clock = name == clocks_.end() ? runs.end() : runs.find(name->second);
    if (clock == runs.end() || values_of(clock->second, "processor_seconds").empty()) continue;
    const auto mean = [&](const char* metric) { return statistics_of(clock->second, metric).mean; };
    const double duration =
        scene == Scene::element ? planned(clock->first)->test->final_strain / paper_rate_ : mean("duration");
    report.paper[scene] = {paper_grains_, duration / paper_time_step_, mean("processor_seconds") / mean("grain_steps")};
  }
  return report;
}

void SpeedCase::compare(const Ensembles& runs, std::map<std::string, double>& metrics) const {
  for (const SettingError& row : errors_of(axes_, runs)) {
    const std::string& axis = row.axis->name;
    metrics[axis + "." + row.setting + ".error_over_spread"] = row.error_over_spread;
    for (const QuantityError& error : row.errors) {
      metrics[axis + "." + row.setting + "." + error.quantity + ".error"] = error.error;
      metrics[axis + "." + row.setting + "." + error.quantity + ".error_over_spread"] = error.at_most();
      metrics[axis + "." + row.setting + "." + error.quantity + ".least_error_over_spread"] = error.at_least();
    }
    double& largest = metrics[axis + ".largest_error_over_spread"];
    largest = std::max(largest, row.error_over_spread);
    const Ensemble& reference = runs.at(row.axis->reference);
    if (!values_of(reference, "steps").empty())
      metrics[axis + "." + row.setting + ".steps_share"] = row.steps / statistics_of(reference, "steps").mean;
  }
}

std::vector<std::string> SpeedCase::tables() const {
  std::vector<std::string> tables{"paper"};  // "table" is reserved for every case
  for (const Scene scene : all_scenes)
    tables.insert(tables.end(), {"errors_" + name_of(scene), name_of(scene) + "_front"});
  return tables;
}

void SpeedCase::finish(const OutputFolder& output) const {
  const Ensembles runs = results_in(output.path(), points_in(output));
  const Report report = report_on(runs);
  write_report(output.path(), report);
  std::cerr << markdown(report) << '\n';
}

}  // namespace flowslide
