// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <iostream>
#include <stdexcept>

#include "configuration/error.hpp"
#include "configuration/tables.hpp"
#include "dem/make_engine.hpp"
#include "input/read_closed_form_sample.hpp"
#include "input/read_coupling.hpp"
#include "input/read_samples.hpp"
#include "process/mpi_session.hpp"
#include "process/ranks.hpp"
#include "program/named.hpp"
#include "program/plan.hpp"
#include "program/replicates.hpp"
#include "program/slide_progress.hpp"
#include "record/gnuplot_table.hpp"
#include "record/hash.hpp"
#include "sample/closed_form.hpp"

namespace flowslide {
namespace {

std::string row_text(const Series& rows) {
  return fmt::format("t {:.3f} s, strain {:.2f} %, tau {:.0f} Pa, sigma {:.0f} Pa", rows.axis.values.back(),
                     100.0 * rows.column("shear_strain").values.back(), rows.column("shear_stress").values.back(),
                     rows.column("normal_stress").values.back());
}

/// Whether the engine can run a point. A closed-form sample runs no element test. The LIGGGHTS engine cannot shear or
/// compress a sample that is periodic along z.
bool can_run(const SlidePoint& point, bool closed_form) {
  if (closed_form) return !point.test;
  return !(point.sample.recipe.periodic_height && point.engine.starts_with("liggghts"));
}

/// Calls `all`, which restores a checkpoint. A checkpoint that does not fit is no defect of the program: its sample may
/// have been prepared again since, by another engine. Therefore throws ConfigurationError.
void restore(const SlidePoint& running, const std::function<void()>& all) {
  try {
    all();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(fmt::format("the checkpoint of {} does not fit: {}; begin this run anew with --afresh",
                                         running.point.name, error.what()));
  }
}

void write_tables(const OutputFolder& output, const Result& result, const Series& profiles) {
  const std::string& point = result.provenance.point;
  Table table = table_of(result);
  write_table(output.file(point + ".dat"), table);
  table.series = profiles;
  if (!profiles.columns.empty()) write_table(output.file(point + "_profiles.dat"), table);
}

}  // namespace

/// The records of a slide or element test.
struct SlideCase::Records {
  Series series, profiles;
  Stop stop = Stop::not_yet;
  RunMeasures measures = {};
  Series measured = {};  ///< rows of an element test at fixed strains, for its metrics
  std::vector<Shot> shots = {};  ///< states of the sample of an element test, for pictures
};

/// A sample, and what is recorded of it.
struct SlideCase::Loaded {
  std::unique_ptr<Sample> sample;
  DemSample* grains = nullptr;        ///< the sample if it is a DEM sample
  std::vector<Metric> metrics;        ///< metrics of the sample
  std::string name;                   ///< see Provenance::sample
};

SlideCase::SlideCase(CaseDescription description) : description_(std::move(description)) {
  if (!description_.engines.empty()) return;
  description_.engines = engine_names();
  for (const std::string& name : closed_form_sample_names()) description_.engines.push_back(name);
}

void SlideCase::read(const Configuration& configuration) {
  configuration.refuse_renamed("element_test", "shear_test");
  const std::string engine = configuration.text("engine", description_.engines);
  preparation_engine_ = configuration.text("preparation.engine", engine_names());
  slope_ = read_slope(configuration);
  check_strength(configuration, slope_, read_material(configuration).sliding_friction);
  seed_ = configuration.integer("seed", Range::between(0, 1e9));
  std::function<std::unique_ptr<Sample>()> closed_form;
  if (is_closed_form(engine)) {
    read_closed_form_sample(configuration, engine, slope_);
    closed_form = [configuration, engine, slope = slope_] {
      return read_closed_form_sample(configuration, engine, slope);
    };
  }
  for (const std::string& name : closed_form_sample_names()) configuration.accept(name);
  const auto replicates = static_cast<int>(configuration.integer("replicates", Range::between(1, 100)));
  std::vector<std::vector<SampleSpecification>> all_samples;
  for (int replicate = 0; replicate < replicates; ++replicate)
    all_samples.push_back(read_samples(configuration, slope_, replicate));
  refuse_equal_recipes(configuration, all_samples);
  for (int replicate = 0; replicate < replicates; ++replicate) {
    const CommonSettings common{replicate, all_samples[static_cast<std::size_t>(replicate)], slope_, engine};
    for (const std::string& name : configuration.subtables("point")) {
      const Tables table(configuration, with_like(configuration, "point", name));
      if (table.has("replicates") && replicate >= table.integer("replicates", Range::between(1, 100))) continue;
      SlidePoint read = read_slide_point(configuration, name, common);
      read.closed_form = closed_form;
      if (closed_form) {
        read.point.sample.clear();
        read.point.grains = 0;
      } else {
        read.point.inputs.preparation_engine = preparation_engine_;
      }
      if (!read.profiles.strains.empty()) read.point.tables.push_back(read.point.name + "_profiles");
      if (read.test && !picture_strains(read).empty()) read.point.tables.push_back(read.point.name + "_frames");
      for (const Metric& parameter : more_parameters(read)) read.parameters.push_back(parameter);
      if (can_run(read, closed_form != nullptr))
        slides_.push_back(std::move(read));
      else if (replicate == 0)
        left_out_.push_back(std::move(read));
    }
  }
}

std::vector<Point> SlideCase::points() const {
  std::vector<Point> points;
  for (const SlidePoint& slide : slides_) points.push_back(slide.point);
  return points;
}

const SlidePoint& SlideCase::slide(const std::string& point) const {
  return named(slides_, "run", point, [](const SlidePoint& slide) { return slide.point.name; });
}

void SlideCase::print_plan(const Point& point, std::ostream& out) const {
  const SlidePoint& planned = slide(point.name);
  const SlideSettings& settings = planned.settings;
  if (!planned.closed_form) print_sample_plan(out, planned.sample, preparation_engine_);
  print_engine_plan(out, planned.sample.recipe, planned.engine, settings.passing.time_step);
  if (planned.test) {
    const double step = settings.passing.time_step;
    out << fmt::format("# {} steps of {} s, {} rows\n", planned.test->steps(step), step,
                       planned.test->row_steps(step).size());
    return;
  }
  out << fmt::format("# {:.0f} global steps of {} s, about {:.3g} local steps of {} s\n",
                     std::ceil(planned.stop.end_time / settings.time_step), settings.time_step,
                     predicted_steps(settings, planned.stop), settings.passing.time_step);
}

void SlideCase::prepare(const Point& point, int threads, const ProgressStyle& progress,
                        const PreparationPoll& poll) const {
  if (slide(point.name).closed_form) return;
  const SampleSpecification& sample = slide(point.name).sample;
  const auto engine = make_engine(preparation_engine_, "/dev/null", threads, all_ranks());
  const FoundSample found = find_sample(*engine, sample, sample_cache_folder(), progress, poll);
  on_first_rank([&] { print_found_sample(std::cout, sample, found); });
}

SlideCase::Loaded SlideCase::load(SlidePoint& slide, const PointRun& run) const {
  Loaded loaded;
  if (slide.closed_form) {
    loaded.sample = slide.closed_form();
    loaded.metrics = {{"initial_void_ratio", loaded.sample->void_ratio(), "1", "void ratio of the closed-form sample"}};
    loaded.name = slide.engine;
    return loaded;
  }
  const auto preparing = make_engine(preparation_engine_, run.output.file(slide.point.name + ".preparation.log"),
                                     run.threads, all_ranks());
  const FoundSample found = find_sample(*preparing, slide.sample, sample_cache_folder(), run.progress,
                                        [&](const auto& keep) { run.checkpoints.poll_in_preparation(keep); });
  loaded.metrics = metrics_of(found);
  slide = on_sample(std::move(slide), found.sample.assembly.mean_diameter());
  loaded.name = found.name;
  const auto log = run.output.file(slide.point.name + "." + slide.engine + ".log");
  auto grains = std::make_unique<DemSample>(make_engine(slide.engine, log, run.threads, all_ranks()),
                                            found.sample.assembly,
                                            EngineSettings{slide.sample.recipe.material,
                                                           slide.settings.passing.time_step, 0.0},
                                            slide.sample.strain_height);
  if (slide.linear_start) grains->start_linear_at_first_strain();
  loaded.grains = grains.get();
  loaded.sample = std::move(grains);
  return loaded;
}

SlideCase::Records SlideCase::shear(const SlidePoint& running, Loaded& loaded, const PointRun& run) const {
  ShearTestRecord previous;
  std::vector<Shot> shots;
  const std::vector<double> strains_of_shots = picture_strains(running);
  std::int64_t done = 0;
  const std::int64_t steps = running.test->steps(running.settings.passing.time_step);
  if (const auto& found = run.checkpoints.found()) {
    restore(running, [&] { loaded.sample->restore(found->sample); });
    previous = {found->partial_result.series, found->measured};
    shots = found->shots;
    done = std::llround(loaded.grains->time() / running.settings.passing.time_step);
  }
  const auto records_of = [](const ShearTestRecord& record, Stop stop) {
    return Records{record.rows, {}, stop, measures_of_rows(record.measured), record.measured};
  };
  const auto checkpoint = [&](Result result, std::int64_t at, const Series& measured) {
    const double share = static_cast<double>(at) / static_cast<double>(steps);
    return Checkpoint{std::move(result), share, loaded.sample->state(), {}, shots, measured};
  };
  Progress progress(fmt::format("{} {}", description_.name, running.point.name), steps, run.progress, done);
  const auto observe = [&](std::int64_t at, const Assembly& assembly, const ShearTestRecord& record) {
    const double strain = loaded.grains->shear_strain();
    if (shots.size() < strains_of_shots.size() && strain >= strains_of_shots[shots.size()])
      shots.push_back({record.rows.axis.values.back(), strain, assembly});
    progress.update(at, row_text(record.rows));
    run.checkpoints.poll([&] {
      return checkpoint(judged(running, loaded, run, records_of(record, Stop::not_yet)), at, record.measured);
    });
  };
  const ShearTestRecord record = run_shear_test(*loaded.grains, *running.test, observe, std::move(previous));
  progress.finish();
  Records records = records_of(record, Stop::end_shear_strain);
  run.checkpoints.keep_end(checkpoint(result_of(running, loaded, run, records), steps, record.measured));
  records.shots = std::move(shots);
  return records;
}

SlideCase::Records SlideCase::slide_on(const SlidePoint& running, Loaded& loaded, const PointRun& run) const {
  Slide sliding(running.settings, *loaded.sample);
  SlideRecord record{running.rows, running.grains};
  record.exchanges = ExchangeRecord(running.grains, mean_stress_interval());
  ProfileRecord profiles(running.profiles);
  if (const auto& found = run.checkpoints.found()) {
    if (!found->slide)
      throw CorruptFileError(fmt::format("the checkpoint of {} is not of a slide", running.point.name));
    restore(running, [&] {
      loaded.sample->restore(found->sample);
      profiles.restore(found->slide->profiles);
      sliding.restore(found->slide->state);
      record.exchanges.restore(found->slide->exchanges);
    });
    record.spacing = found->slide->spacing;
    record.series = found->partial_result.series;
    record.next_time = found->slide->next_time;
    record.next_strain = found->slide->next_strain;
  }
  SlideProgress progress(fmt::format("{} {}", description_.name, running.point.name), running.settings, running.stop,
                         run.progress, sliding.state());
  const auto records_of = [&](Stop stop) {
    return Records{record.series, profiles.series(), stop, record.exchanges.measures()};
  };
  const auto checkpoint = [&](Result result) {
    const SlideState& state = sliding.state();
    return Checkpoint{std::move(result),
                      progress.share_done(state),
                      loaded.sample->state(),
                      SlideCheckpoint{state, record.spacing, record.next_time, record.next_strain, profiles.sums(),
                                      profiles.series(), record.exchanges},
                      {}};
  };
  const auto after_exchange = [&](const SlideState& state) {
    progress.update(state);
    if (loaded.grains) profiles.take(state.strain.shear, *loaded.grains);
    run.checkpoints.poll([&] { return checkpoint(judged(running, loaded, run, records_of(Stop::not_yet))); });
    return true;
  };
  const Stop stop = run_slide(sliding, running.stop, record, after_exchange);
  progress.finish(sliding.state());
  Records records = records_of(stop);
  run.checkpoints.keep_end(checkpoint(result_of(running, loaded, run, records)));
  return records;
}

Provenance SlideCase::provenance_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run) const {
  Provenance provenance = run.provenance_now();
  provenance.seed = seed_;
  provenance.replicate = running.replicate;
  provenance.sample = loaded.name;
  return provenance;
}

Result SlideCase::result_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run,
                            const Records& records) const {
  Result result = run.result(records.series, loaded.metrics);
  result.provenance = provenance_of(running, loaded, run);
  result.parameters = running.parameters;
  result.windows = records.measures.windows();
  return result;
}

void SlideCase::judge(Result& result, const SlidePoint& running, const Loaded& loaded, const Records& records) const {
  const Series& series = running.test ? records.measured : records.series;
  const SlideOutcome outcome{running, series, records.measures, records.profiles, records.stop, loaded.grains};
  for (const Metric& metric : slide_metrics(outcome))
    if (std::isfinite(metric.value)) result.metrics.push_back(metric);
}

Result SlideCase::judged(const SlidePoint& running, const Loaded& loaded, const PointRun& run,
                         const Records& records) const {
  Result result = result_of(running, loaded, run, records);
  try {
    judge(result, running, loaded, records);
  } catch (const std::exception&) {  // a checkpoint must be written even if its metrics cannot be computed
    result.metrics = loaded.metrics;
  }
  return result;
}

void SlideCase::run(const Point& point, const PointRun& run) const {
  SlidePoint running = slide(point.name);
  Loaded loaded = load(running, run);
  std::vector<std::string> names;
  for (const SlidePoint& other : slides_) names.push_back(other.point.name);
  on_first_rank([&] {
    refuse_sample_of_others(provenance_of(running, loaded, run), hash_of(run.identity.configuration()),
                            run.output.path(), names);
  });
  const Records records = running.test ? shear(running, loaded, run) : slide_on(running, loaded, run);
  Result result = result_of(running, loaded, run, records);
  // The tables come before the metrics, which may fail, and before the file <point>.h5, which marks a complete run.
  on_first_rank([&] {
    if (!records.shots.empty()) write_pictures(run.output, running, records.shots);
    write_tables(run.output, result, records.profiles);
  });
  judge(result, running, loaded, records);
  on_first_rank([&] { write_result(run.output.file(point.name + OutputFolder::result_end), result); });
}

}  // namespace flowslide
