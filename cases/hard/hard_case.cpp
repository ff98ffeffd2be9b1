// SPDX-License-Identifier: GPL-2.0-or-later
#include "hard_case.hpp"

#include <fmt/format.h>

#include <ostream>

#include "dem/make_engine.hpp"
#include "process/ranks.hpp"
#include "program/named.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"
#include "record/result_file.hpp"

namespace flowslide {
namespace {

std::vector<Metric> counts_of(const std::vector<SceneTrial>& trials) {
  const auto count = [&](const char* name, int number, const char* text) {
    return Metric{name, static_cast<double>(number), "1", text};
  };
  const int wrong = count_of(trials, Outcome::silently_wrong), needless = count_of(trials, Outcome::needless);
  return {count("accurate", count_of(trials, Outcome::accurate), "trials that are accurate"),
          count("stable", count_of(trials, Outcome::stable), "trials that are stable but not accurate"),
          count("refused", count_of(trials, Outcome::refused), "trials that are refused with a reason"),
          count("silently_wrong", wrong, "trials that are wrong without an error"),
          count("needlessly_refused", needless, "trials that are refused but must run"),
          count("failures", wrong + needless, "trials that are silently wrong or refused needlessly")};
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<HardCase>(); }

CaseDescription HardCase::description() const {
  return {"hard", "Scenes that break codes of this kind, each with a verdict", FLOWSLIDE_VERSION, {}, engine_names()};
}

void HardCase::read(const Configuration& configuration) {
  settings_ = SceneSettings::read(configuration);
  scenes_ = scenes_of(settings_);
}

std::vector<Point> HardCase::points() const {
  std::vector<Point> points;
  const RunInputs inputs{settings_.engine, settings_.engine, settings_.inputs};
  for (const Scene& scene : scenes_)
    points.push_back({scene.name, {}, scene.title, scene.seconds, {}, inputs, {scene.name + "_details"}});
  return points;
}

const Scene& HardCase::scene(const std::string& name) const {
  return named(scenes_, "scene", name, &Scene::name);
}

void HardCase::print_plan(const Point& point, std::ostream& out) const {
  const Scene& planned = scene(point.name);
  out << fmt::format("# {}\n# right: {}\n", planned.title, planned.right);
}

void HardCase::run(const Point& point, const PointRun& run) const {
  const SceneRecord record = scene(point.name).run(SceneContext(settings_, run));
  Result result = run.result(series_of(record.trials), counts_of(record.trials));
  result.metrics.insert(result.metrics.end(), record.metrics.begin(), record.metrics.end());
  result.provenance.seed = settings_.seed;
  on_first_rank([&] {
    Table table = table_of(result);
    write_table(run.output.file(point.name + ".dat"), table);
    write_atomically(run.output.file(point.name + ".md"), markdown_rows(point.name, record.trials));
    table.series = record.details;
    if (!record.details.columns.empty()) write_table(run.output.file(point.name + "_details.dat"), table);
    write_result(run.output.file(point.name + ".h5"), result);
  });
}

std::map<std::string, double> HardCase::metrics(const std::filesystem::path& folder,
                                                const std::vector<std::string>& points) const {
  std::map<std::string, double> all;
  for (const std::string& point : points)
    for (const Metric& metric : read_result(folder / (point + ".h5")).metrics)
      all[point + "." + metric.name] = metric.value;
  return all;
}

void HardCase::finish(const OutputFolder& output) const {
  std::string table = "| Scene | What is right, and the tolerance | Trials | Verdict |\n|---|---|---|---|\n";
  std::string trials = "| Scene | Setting | Right | Measured | Outcome | Reason |\n|---|---|---|---|---|---|\n";
  for (const Scene& scene : scenes_) {
    if (!output.has_result(scene.name)) continue;
    const std::vector<double> outcomes = read_result(output.file(scene.name + ".h5")).series.column("outcome").values;
    std::vector<SceneTrial> judged(outcomes.size());
    for (std::size_t i = 0; i < outcomes.size(); ++i) judged[i].outcome = static_cast<Outcome>(outcomes[i]);
    table += fmt::format("| {} | {} | {} | {} |\n", scene.title, scene.right, judged.size(), verdict_of(judged));
    trials += read_file(output.file(scene.name + ".md"));
  }
  write_atomically(output.file("table.md"), table);
  write_atomically(output.file("trials.md"), trials);
}

}  // namespace flowslide
