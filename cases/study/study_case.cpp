// SPDX-License-Identifier: GPL-2.0-or-later
#include "study_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <map>

#include "configuration/error.hpp"
#include "program/named.hpp"
#include "program/runout.hpp"
#include "record/gnuplot_table.hpp"
#include "study_tables.hpp"

namespace flowslide {
namespace {

/// The resolved configuration without the number of replicates, which changes no single run.
std::string without_replicates(std::string resolved) {
  const std::size_t start = resolved.find("\nreplicates = ") + 1;  // "engine" stands before it
  return resolved.erase(start, resolved.find('\n', start) + 1 - start);
}

void refuse_points(const Configuration& configuration) {
  const std::vector<std::string> points = configuration.subtables("point");
  if (points.empty()) return;
  throw ConfigurationError(fmt::format(
      "{}: a study has no [point.{}]; give its sample and schemes in [study], and what differs between runs in [sweep]",
      configuration.place_of({"point." + points.front()}), points.front()));
}

/// The scheme names columns of tables, so it must be a valid name of one.
void refuse_unusual_schemes(const Configuration& configuration, const std::vector<std::string>& schemes) {
  for (const std::string& scheme : schemes) {
    if (!is_valid_name(scheme))
      configuration.refuse("study.scheme", fmt::format("names \"{}\", which can name no column of a table", scheme),
                           "use letters, digits and \"_\", a letter first");
    if (std::ranges::count(schemes, scheme) > 1)
      configuration.refuse("study.scheme", fmt::format("gives \"{}\" twice", scheme), "give each scheme once");
  }
}

/// Refuses a key that the user both fixes and sweeps: one of the two values would have no effect.
void refuse_fixed_key(const Configuration& configuration, const Sweep& sweep, const std::string& sample) {
  for (const std::string& key : sweep.replaced(configuration, sample))
    if (configuration.is_users(key))
      configuration.refuse(key,
                           fmt::format("is fixed here, but it is also swept ({})", configuration.place_of({"sweep"})),
                           fmt::format("remove \"{}\" to sweep it, or \"{}\" to keep it fixed", key, sweep.key));
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<StudyCase>(); }

StudyCase::StudyCase()
    : SlideCase({"study",
                 "A study of your own: any slope, sample, loading and scheme, single or over a sweep. The study is the "
                 "file of --config (docs/own-study.md)",
                 FLOWSLIDE_VERSION,
                 {},
                 {}}) {}

void StudyCase::read(const Configuration& configuration) {
  refuse_points(configuration);
  engine_ = configuration.text("engine", description().engines);
  sample_ = configuration.text("study.sample", configuration.subtables("sample"));
  schemes_ = configuration.texts("study.scheme", configuration.subtables("scheme"));
  refuse_unusual_schemes(configuration, schemes_);
  sweep_ = read_sweep(configuration, engine_, sample_);
  if (sweep_.exists()) refuse_fixed_key(configuration, sweep_, sample_);
  for (std::size_t scheme = 0; scheme < schemes_.size(); ++scheme) {
    if (!sweep_.exists()) read_run(configuration, scheme, nullptr);
    for (const SweepValue& value : sweep_.values) read_run(configuration, scheme, &value);
  }
}

void StudyCase::read_run(const Configuration& configuration, std::size_t scheme, const SweepValue* value) {
  const std::string name = value == nullptr ? schemes_[scheme] : schemes_[scheme] + "_" + value->file_name;
  runs_.push_back({name, schemes_[scheme], value == nullptr ? SweepValue{} : *value});
  const std::string point = "point." + name;
  Configuration own = configuration.with_item(point + ".sample", "study.sample", 0)
                          .with_item(point + ".scheme", "study.scheme", scheme)
                          .with_item(point + ".figures", "study.figures", 0);
  const std::string target = sweep_.target(name, sample_);
  if (value != nullptr) own = own.with_item(target, sweep_.key, value->item);
  SlideCase::read(own);
  if (value != nullptr) own.require_effect(target);
  runs_.back().configuration = without_replicates(own.resolved());
  configuration.adopt(own);
}

const StudyRun& StudyCase::run_named(const std::string& name) const {
  return named(runs_, "run", name, &StudyRun::name);
}

std::vector<Point> StudyCase::points() const {
  std::vector<Point> points = SlideCase::points();
  std::map<std::string, std::string> recipes;  // label of a sample -> its recipe and target
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SlidePoint& slide = slides()[i];
    const StudyRun& run = run_named(slide.name);
    points[i].configuration = run.configuration;
    if (points[i].sample.empty()) continue;
    const std::string recipe = fmt::format("{}{}", slide.sample.recipe.text(), slide.sample.target.void_ratio);
    if (recipes.emplace(points[i].sample, recipe).first->second != recipe)
      points[i].sample += fmt::format("_{}", run.value.item);
  }
  return points;
}

std::vector<Metric> StudyCase::slide_metrics(const SlideOutcome& outcome) const { return pulse_runout(outcome); }

std::vector<Metric> StudyCase::more_parameters(const SlidePoint& point) const {
  if (!sweep_.exists() || !sweep_.is_of_numbers) return {};
  return {{"swept_" + sweep_.name, run_named(point.name).value.number, sweep_.si_unit, sweep_.axis_label()}};
}

std::vector<std::string> StudyCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  for (const std::string& name : slide_names()) tables.push_back(name + "_coarse");
  tables.insert(tables.end(), {"slides", "sweep", "legend", "study"});
  return tables;
}

void StudyCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles slides = results_in(output.path(), points_in(output));
  for (const auto& [name, ensemble] : slides)
    write_table(output.file(name + "_coarse.dat"),
                {{{"case", description().name}, {"slide", name}}, coarse_band(ensemble)});
  const auto& counts = this->slides().front().sample.recipe.packing.counts;
  const std::string grains = this->slides().front().closed_form
                                 ? "no grains"
                                 : fmt::format("{} grains", std::int64_t{counts[0]} * counts[1] * counts[2]);
  const StudyFigure study{description().name, engine_ + ", " + grains, schemes_, sweep_, runs_};
  write_study_tables(output, study, slides);
  for (const std::string& scheme : schemes_)
    if (is_sweep_without_effect(study, scheme, slides))
      std::cerr << fmt::format("flowslide: {} has no effect: the runs of {} have the same result for all its values, "
                               "because this sample and loading do not use it\n", sweep_.key, scheme);
}

}  // namespace flowslide
