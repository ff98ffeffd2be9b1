// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/slide_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <stdexcept>

#include "app/closed_form_models.hpp"
#include "app/coupling_models.hpp"
#include "app/error.hpp"
#include "app/plan.hpp"
#include "app/ranks.hpp"
#include "app/slide_progress.hpp"
#include "dem/make_engine.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr int band_rows = 200;  ///< of a figure: finer than what it can show

Table band_table(const std::string& case_name, const std::string& slide, std::size_t replicates, Series series) {
  return {{{"case", case_name}, {"slide", slide}, {"replicates", fmt::format("{}", replicates)}}, std::move(series)};
}

std::string row_text(const Series& rows) {
  return fmt::format("t {:.3f} s, strain {:.2f} %, tau {:.0f} Pa, sigma {:.0f} Pa", rows.axis.values.back(),
                     100.0 * rows.column("shear_strain").values.back(), rows.column("shear_stress").values.back(),
                     rows.column("normal_stress").values.back());
}

/// What a checkpoint does not fit is no defect: its sample may have been prepared anew since, by another engine.
void restore(const SlidePoint& running, const std::function<void()>& all) {
  try {
    all();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("the checkpoint of {} does not fit: {}; begin the point anew with --afresh",
                                         running.point.name, error.what()));
  }
}

/// The tables first: a point is complete with its <point>.h5.
void write_point(const OutputFolder& output, const std::string& point, const Result& result, const Series& profiles) {
  Table table = table_of(result);
  write_table(output.file(point + ".dat"), table);
  table.series = profiles;
  if (!profiles.columns.empty()) write_table(output.file(point + "_profiles.dat"), table);
  write_result(output.file(point + ".h5"), result);
}

}  // namespace

/// What is kept of a point, slide or element test.
struct SlideCase::Records {
  Series series, profiles;
  Stop stop;
};

/// A sample, and what it lives on.
struct SlideCase::Loaded {
  std::unique_ptr<Engine> engine;
  std::unique_ptr<Sample> sample;
  DemSample* grains = nullptr;        ///< the sample, if it is made of them
  std::vector<Metric> metrics;        ///< of the sample
};

SlideCase::SlideCase(CaseDescription description) : description_(std::move(description)) {
  description_.engines = engine_names();
  for (const std::string& name : closed_form_sample_names()) description_.engines.push_back(name);
}

void SlideCase::read(const Configuration& configuration) {
  const std::string engine = configuration.text("engine", description_.engines);
  preparation_engine_ = configuration.text("preparation.engine", engine_names());
  slope_ = read_slope(configuration);
  check_strength(configuration, slope_, read_material(configuration).sliding_friction);
  seed_ = configuration.integer("seed", Range::between(0, 1e9));
  if (is_closed_form(engine)) {
    read_closed_form_sample(configuration, engine, slope_);
    closed_form_ = [configuration, engine, slope = slope_] {
      return read_closed_form_sample(configuration, engine, slope);
    };
  }
  for (const std::string& name : closed_form_sample_names()) configuration.accept(name);
  const auto replicates = static_cast<int>(configuration.integer("replicates", Range::between(1, 100)));
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const auto samples = read_samples(configuration, slope_, replicate);
    for (const std::string& name : configuration.subtables("point")) {
      const std::string key = "point." + name + ".replicates";
      if (configuration.has(key) && replicate >= configuration.integer(key, Range::between(1, 100))) continue;
      SlidePoint read = read_slide_point(configuration, name, replicate, samples, slope_, engine);
      if (closed_form_) read.point.sample.clear();
      else
        read.point.inputs.preparation_engine = preparation_engine_;
      if (!read.test || !closed_form_) slides_.push_back(std::move(read));
    }
  }
}

std::vector<Point> SlideCase::points() const {
  std::vector<Point> points;
  for (const SlidePoint& slide : slides_) points.push_back(slide.point);
  return points;
}

const SlidePoint& SlideCase::slide(const std::string& point) const {
  return *std::find_if(slides_.begin(), slides_.end(), [&](const SlidePoint& s) { return s.point.name == point; });
}

void SlideCase::print_plan(const Point& point, std::ostream& out) const {
  const SlidePoint& planned = slide(point.name);
  const SlideSettings& settings = planned.settings;
  if (!closed_form_) print_sample_plan(out, planned.sample, preparation_engine_);
  print_engine_plan(out, planned.sample.recipe, planned.engine, settings.passing.time_step);
  if (planned.test) {
    out << fmt::format("# {} steps of {} s\n", planned.test->steps(settings.passing.time_step),
                       settings.passing.time_step);
    return;
  }
  out << fmt::format("# {:.0f} global steps of {} s, about {:.3g} local steps of {} s\n",
                     std::ceil(planned.stop.end_time / settings.time_step), settings.time_step,
                     predicted_steps(settings, planned.stop), settings.passing.time_step);
}

void SlideCase::prepare(const Point& point, const ProgressStyle& progress, const PreparationBorder& border) const {
  if (closed_form_) return;
  const SampleSpecification& sample = slide(point.name).sample;
  const FoundSample found =
      find_sample(*make_engine(preparation_engine_, "/dev/null"), sample, sample_cache_folder(), progress, border);
  on_first_rank([&] { print_found_sample(std::cout, sample, found); });
}

SlideCase::Loaded SlideCase::load(SlidePoint& slide, const PointRun& run) const {
  Loaded loaded;
  if (closed_form_) {
    loaded.sample = closed_form_();
    return loaded;
  }
  const auto preparing =
      make_engine(preparation_engine_, run.output.file(slide.point.name + ".preparation.log"), run.threads);
  const FoundSample found = find_sample(*preparing, slide.sample, sample_cache_folder(), run.progress,
                                        [&](const auto& keep) { run.checkpoints.border_of_preparation(keep); });
  loaded.metrics = metrics_of(found);
  slide = on_sample(std::move(slide), found.sample.assembly.mean_diameter());
  loaded.engine =
      make_engine(slide.engine, run.output.file(slide.point.name + "." + slide.engine + ".log"), run.threads);
  auto grains = std::make_unique<DemSample>(*loaded.engine, found.sample.assembly,
                                            EngineSettings{slide.sample.recipe.material,
                                                           slide.settings.passing.time_step, 0.0});
  if (slide.linear_start) grains->start_linear_at_first_strain();
  loaded.grains = grains.get();
  loaded.sample = std::move(grains);
  return loaded;
}

SlideCase::Records SlideCase::shear(const SlidePoint& running, Loaded& loaded, const PointRun& run) const {
  Records records{element_test_series(), {}, Stop::not_yet};
  std::int64_t done = 0;
  const std::int64_t steps = running.test->steps(running.settings.passing.time_step);
  if (const auto& found = run.checkpoints.found()) {
    restore(running, [&] { loaded.sample->restore(found->sample); });
    records.series = found->so_far.series;
    done = loaded.grains->steps();
  }
  Progress progress(fmt::format("{} {}", description_.name, running.point.name), steps, run.progress, done);
  const auto observe = [&](std::int64_t at, const Assembly&, const Series& rows) {
    progress.update(at, row_text(rows));
    run.checkpoints.border([&] {
      return Checkpoint{result_of(running, loaded, run, {rows, {}, Stop::not_yet}),
                        static_cast<double>(at) / static_cast<double>(steps), loaded.sample->state(), {}, {}};
    });
  };
  records.series = run_element_test(*loaded.grains, *running.test, observe, std::move(records.series));
  records.stop = Stop::end_shear_strain;
  progress.finish();
  return records;
}

SlideCase::Records SlideCase::slide_on(const SlidePoint& running, Loaded& loaded, const PointRun& run) const {
  Slide sliding(running.settings, *loaded.sample);
  SlideRecord record{running.rows, running.grains};
  ProfileRecord profiles(running.profiles);
  if (const auto& found = run.checkpoints.found()) {
    if (!found->slide)
      throw CorruptFileError(fmt::format("the checkpoint of {} is not of a slide", running.point.name));
    restore(running, [&] {
      loaded.sample->restore(found->sample);
      profiles.restore(found->slide->profiles);
    });
    sliding.restore(found->slide->state);
    record = {found->slide->spacing, running.grains, found->so_far.series, found->slide->next_time,
              found->slide->next_strain};
  }
  SlideProgress progress(fmt::format("{} {}", description_.name, running.point.name), running.settings, running.stop,
                         run.progress, sliding.state());
  SlideHooks hooks;
  hooks.go_on = [&](const SlideState& state) {
    progress.update(state);
    if (loaded.grains) profiles.take(state.strain.shear, *loaded.grains);
    run.checkpoints.border([&] {
      return Checkpoint{result_of(running, loaded, run, {record.series, profiles.series(), Stop::not_yet}),
                        progress.share_done(state), loaded.sample->state(),
                        SlideCheckpoint{state, record.spacing, record.next_time, record.next_strain, profiles.sums(),
                                        profiles.series()},
                        {}};
    });
    return true;
  };
  const Stop stop = run_slide(sliding, running.stop, record, hooks);
  progress.finish(sliding.state());
  return {std::move(record.series), profiles.series(), stop};
}

Result SlideCase::result_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run,
                            const Records& records) const {
  Result result = run.result(records.series, loaded.metrics);
  try {
    for (const Metric& metric : slide_metrics({running, records.series, records.profiles, records.stop, loaded.grains}))
      if (std::isfinite(metric.value)) result.metrics.push_back(metric);
  } catch (const std::invalid_argument&) {
    if (records.stop != Stop::not_yet) throw;  // a record that is not complete may be too short for them
  }
  result.provenance.seed = seed_;
  result.provenance.replicate = running.replicate;
  return result;
}

void SlideCase::run(const Point& point, const PointRun& run) const {
  SlidePoint running = slide(point.name);
  Loaded loaded = load(running, run);
  const Records records = running.test ? shear(running, loaded, run) : slide_on(running, loaded, run);
  const Result result = result_of(running, loaded, run, records);
  on_first_rank([&] { write_point(run.output, point.name, result, records.profiles); });
}

Ensembles SlideCase::results_in(const std::filesystem::path& folder, const std::vector<std::string>& points) const {
  Ensembles slides;
  for (const std::string& point : points) slides[slide(point).name].push_back(read_result(folder / (point + ".h5")));
  return slides;
}

std::map<std::string, double> SlideCase::metrics(const std::filesystem::path& folder,
                                                 const std::vector<std::string>& points) const {
  const Ensembles slides = results_in(folder, points);
  std::map<std::string, double> all;
  for (const auto& [name, ensemble] : slides) {
    for (const auto& [metric, value] : summary_of(ensemble)) all[fmt::format("{}.{}", name, metric)] = value;
    for (const Result& result : ensemble)
      for (const Metric& metric : result.metrics)
        all[fmt::format("{}.{}", result.provenance.point, metric.name)] = metric.value;
  }
  compare(slides, all);
  std::erase_if(all, [](const auto& metric) { return !std::isfinite(metric.second); });
  return all;
}

std::vector<std::string> SlideCase::points_in(const OutputFolder& output) const {
  std::vector<std::string> present;
  for (const SlidePoint& slide : slides_)
    if (std::filesystem::exists(output.file(slide.point.name + ".h5"))) present.push_back(slide.point.name);
  return present;
}

void SlideCase::finish(const OutputFolder& output) const {
  const std::vector<std::string> present = points_in(output);
  std::map<std::string, std::vector<Series>> profiles;
  for (const std::string& point : present) {
    const auto file = output.file(point + "_profiles.dat");
    if (std::filesystem::exists(file)) profiles[slide(point).name].push_back(read_table(file).series);
  }
  for (const auto& [name, ensemble] : results_in(output.path(), present))
    for (const std::string& abscissa : abscissas())
      write_table(output.file(fmt::format("{}_over_{}.dat", name, abscissa)),
                  band_table(description_.name, name, ensemble.size(), band_over(ensemble, abscissa, band_rows)));
  for (const auto& [name, all] : profiles)
    write_table(output.file(name + "_profiles_band.dat"),
                band_table(description_.name, name, all.size(), band_of_rows(all)));
}

}  // namespace flowslide
