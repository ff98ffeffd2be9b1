// SPDX-License-Identifier: GPL-2.0-or-later
#include "undrained_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "configuration/error.hpp"
#include "configuration/tables.hpp"
#include "curve_metrics.hpp"
#include "curves_table.hpp"
#include "dem/make_engine.hpp"
#include "experiment/ensemble.hpp"
#include "input/read_samples.hpp"
#include "input/read_shear_test.hpp"
#include "process/ranks.hpp"
#include "program/plan.hpp"
#include "program/replicates.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"
#include "record/hash.hpp"
#include "record/result_file.hpp"
#include "run/legend.hpp"

namespace flowslide {
std::unique_ptr<Case> make_case() { return std::make_unique<UndrainedCase>(); }

CaseDescription UndrainedCase::description() const {
  return {"fig03_undrained",
          "Constant-volume simple shear of loose packings (Figs. 2, 3 and 4)",
          FLOWSLIDE_VERSION,
          {"Fig. 2", "Fig. 3", "Fig. 4"},
          engine_names()};
}

void UndrainedCase::read(const Configuration& configuration) {
  engine_ = configuration.text("engine", engine_names());
  preparation_engine_ = configuration.text("preparation.engine", engine_names());
  slope_ = read_slope(configuration);
  seed_ = configuration.integer("seed", Range::between(0, 1e9));
  const auto replicates = static_cast<int>(configuration.integer("replicates", Range::between(1, 100)));
  for (int replicate = 0; replicate < replicates; ++replicate)
    samples_.push_back(read_samples(configuration, slope_, replicate));
  refuse_equal_recipes(samples_);
  for (int replicate = 0; replicate < replicates; ++replicate)
    for (const std::string& name : configuration.subtables("point")) read_curve(configuration, name, replicate);
}

void UndrainedCase::read_curve(const Configuration& configuration, const std::string& name, int replicate) {
  const std::string table = "point." + name + ".";
  Curve curve;
  curve.name = name;
  curve.replicate = replicate;
  std::vector<std::string> names;
  for (const SampleSpecification& sample : samples_[replicate]) names.push_back(sample.name);
  const std::string sample = configuration.text(table + "sample", names);
  curve.sample = static_cast<std::size_t>(std::find(names.begin(), names.end(), sample) - names.begin());
  const SampleRecipe& recipe = sample_of(curve).recipe;
  const TableNames tables{"point." + name, "shear"};
  curve.test = read_shear_test(configuration, tables, recipe);
  const Tables shear(configuration, tables);
  check_time_step(configuration, shear.key("time_step"), recipe.packing.smallest_diameter, recipe.material);
  curve.time_step = shear.positive("time_step", dimension::time);
  if (configuration.has(table + "picture_strain"))
    curve.picture_strain = configuration.number(table + "picture_strain", Range::between(0.0, curve.test.final_strain));

  const auto grains = recipe.packing.counts[0] * recipe.packing.counts[1] * recipe.packing.counts[2];
  const auto steps = as_written_by_user("point " + name, [&] {
    return static_cast<double>(curve.test.steps(curve.time_step));
  });
  curve.point = {replicate_name(name, replicate),
                 configuration.texts(table + "figures"),
                 fmt::format("sample {}, {:.3g} /s to {:.3g} % in {:.3g} steps of {} grains", sample,
                             curve.test.shear_rate, 100.0 * curve.test.final_strain, steps, grains),
                 steps * grains * seconds_per_grain_and_step(engine_),
                 sample_of(curve).label(),
                 {engine_, preparation_engine_}};
  if (curve.picture_strain) curve.point.tables = {curve.point.name + "_frames"};
  curves_.push_back(curve);
}

std::vector<Point> UndrainedCase::points() const {
  std::vector<Point> points;
  for (const Curve& curve : curves_) points.push_back(curve.point);
  return points;
}

const Curve& UndrainedCase::curve(const std::string& name) const {
  return *std::find_if(curves_.begin(), curves_.end(), [&](const Curve& c) { return c.point.name == name; });
}

void UndrainedCase::print_plan(const Point& point, std::ostream& out) const {
  const Curve& planned = curve(point.name);
  const SampleSpecification& sample = sample_of(planned);
  print_sample_plan(out, sample, preparation_engine_);
  print_engine_plan(out, sample.recipe, engine_, planned.time_step);
  out << fmt::format("# {} steps of {} s, {} rows\n", planned.test.steps(planned.time_step), planned.time_step,
                     planned.test.row_steps(planned.time_step).size());
}

FoundSample UndrainedCase::sample_for(const Curve& curve, const std::filesystem::path& log,
                                      const ProgressStyle& progress, int threads,
                                      const PreparationBorder& border) const {
  return find_sample(*make_engine(preparation_engine_, log, threads), sample_of(curve), sample_cache_folder(), progress,
                     border);
}

void UndrainedCase::prepare(const Point& point, const ProgressStyle& progress, const PreparationBorder& border) const {
  const Curve& wanted = curve(point.name);
  const FoundSample found = sample_for(wanted, "/dev/null", progress, 0, border);
  on_first_rank([&] { print_found_sample(std::cout, sample_of(wanted), found); });
}

std::vector<Metric> UndrainedCase::parameters_of(const Curve& curve) const {
  return {{"void_ratio", sample_of(curve).target.void_ratio, "1", "void ratio that was looked for"},
          {"time_step", curve.time_step, "s", "time step dt_L"},
          {"shear_rate", curve.test.shear_rate, "1/s", "shear rate"},
          {"final_strain", curve.test.final_strain, "1", "shear strain at the end"}};
}

Result UndrainedCase::result_of(const Curve& running, const FoundSample& found, const PointRun& run,
                                const ShearTestRecord& record) const {
  Result result = run.result(record.rows, metrics_of(found));
  result.parameters = parameters_of(running);
  result.windows = measures_of_rows(record.measured).windows();
  result.provenance.seed = seed_;
  result.provenance.replicate = running.replicate;
  result.provenance.sample = found.name;
  return result;
}

void UndrainedCase::judge(Result& result, const Curve& running, const ShearTestRecord& record) const {
  for (const Metric& metric : curve_metrics(record.measured, sample_of(running).recipe.normal_stress))
    result.metrics.push_back(metric);
}

ShearTestRecord UndrainedCase::shear(const Curve& running, const FoundSample& found, DemSample& sample,
                                       Pictures& pictures, const PointRun& run) const {
  ShearTestRecord so_far;
  if (const auto& kept = run.checkpoints.found()) {
    sample.restore(kept->sample);
    pictures.restore(kept->shots);
    so_far = {kept->so_far.series, kept->measured};
  }
  const std::int64_t steps = running.test.steps(running.time_step);
  Progress progress("fig03_undrained " + running.point.name, steps, run.progress, sample.steps());
  const auto checkpoint = [&](Result result, std::int64_t done, const Series& measured) {
    return Checkpoint{std::move(result), static_cast<double>(done) / static_cast<double>(steps),
                      sample.state(),    {},
                      pictures.shots(),  measured};
  };
  const auto observe = [&](std::int64_t done, const Assembly& assembly, const ShearTestRecord& record) {
    pictures.take(record.rows.axis.values.back(), sample.shear_strain(), assembly);
    progress.update(done, fmt::format("t {:.3f} s, strain {:.1f} %, tau {:.0f} Pa, sigma {:.0f} Pa", sample.time(),
                                      100.0 * sample.shear_strain(), sample.stress().shear, sample.stress().normal));
    run.checkpoints.border([&] {
      Result result = result_of(running, found, run, record);
      judge(result, running, record);
      return checkpoint(std::move(result), done, record.measured);
    });
  };
  ShearTestRecord record = run_shear_test(sample, running.test, observe, std::move(so_far));
  progress.finish();
  run.checkpoints.keep_end(checkpoint(result_of(running, found, run, record), steps, record.measured));
  return record;
}

void UndrainedCase::run(const Point& point, const PointRun& run) const {
  Curve running = curve(point.name);
  const FoundSample found = sample_for(running, run.output.file(point.name + ".preparation.log"), run.progress,
                                       run.threads,
                                       [&](const auto& keep) { run.checkpoints.border_of_preparation(keep); });
  const auto engine = make_engine(engine_, run.output.file(point.name + "." + engine_ + ".log"), run.threads);
  std::vector<std::string> names;
  for (const Curve& other : curves_) names.push_back(other.point.name);
  on_first_rank([&] {
    refuse_sample_of_others(result_of(running, found, run, {}).provenance, hash_of(run.identity.configuration()),
                            run.output.path(), names);
  });
  running.test = for_sample(running.test, sample_of(running).recipe, found.sample.assembly.mean_diameter());
  DemSample sample(*engine, found.sample.assembly, {sample_of(running).recipe.material, running.time_step, 0.0});
  Pictures pictures(running.picture_strain);
  const ShearTestRecord record = shear(running, found, sample, pictures, run);
  Result result = result_of(running, found, run, record);
  judge(result, running, record);
  on_first_rank([&] {
    pictures.write(run.output, point.name);
    write_table(run.output.file(point.name + ".dat"), table_of(result));
    write_result(run.output.file(point.name + ".h5"), result);
  });
}

std::map<std::string, double> UndrainedCase::metrics(const std::filesystem::path& folder,
                                                     const std::vector<std::string>& points) const {
  std::map<std::string, double> all;
  Ensembles curves;
  std::vector<Provenance> origins;
  for (const std::string& name : points) {
    Ensemble& replicates = curves[curve(name).name];
    replicates.push_back(read_result(folder / (name + ".h5")));
    origins.push_back(replicates.back().provenance);
    for (const Metric& metric : replicates.back().metrics) all[name + "." + metric.name] = metric.value;
  }
  refuse_equal_samples(origins);
  for (const auto& [name, replicates] : curves)
    for (const auto& [metric, value] : summary_of(replicates)) all[name + "." + metric] = value;
  const auto slow = all.find("I_1e-4.peak_shear_stress.median"), fast = all.find("I_2e-2.peak_shear_stress.median");
  if (slow != all.end() && fast != all.end()) all["rate_effect"] = fast->second / slow->second;
  return all;
}

void UndrainedCase::finish(const OutputFolder& output) const {
  Legend legend;
  std::vector<std::pair<std::string, std::vector<Metric>>> all;
  for (const Curve& curve : curves_) {
    const std::string& name = curve.point.name;
    if (!output.has_result(name)) continue;
    all.emplace_back(name, read_result(output.file(name + ".h5")).metrics);
    for (const Metric& metric : all.back().second) {
      if (name.starts_with("e0") && metric.name == "initial_void_ratio")
        legend.add(name, fmt::format("e_0 = {:.3f}", metric.value));
      if (name.starts_with("I_") && metric.name == "initial_inertial_number")
        legend.add(name, fmt::format("I = {:.0e}", metric.value));
    }
  }
  legend.write(output);
  write_atomically(output.file("curves.dat"), curves_table(all));
}

}  // namespace flowslide
