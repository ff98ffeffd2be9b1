// SPDX-License-Identifier: GPL-2.0-or-later
// engine_bench [--grains N] [--engine NAME] [Google Benchmark's options]
// Time of a step and of an exchange (steering the boundaries, reading the stress, counting grains) of a prepared sample
// that is sheared slowly. Samples come from the cache and are prepared if they are not there.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>

#include "app/error.hpp"
#include "app/sample_cache.hpp"
#include "dem/liggghts/instance.hpp"
#include "dem/make_engine.hpp"
#include "sample/dem_sample.hpp"

namespace {

using namespace flowslide;

constexpr int steps_per_round = 10;
constexpr double shear_rate = 0.055;  // 1/s: I = 1e-4 at 28 kPa, so that the sample stays dense while it is timed

/// A lattice of about that many grains with the proportions of the paper's.
std::array<int, 3> lattice_of(int grains) {
  const int side = std::max(3, static_cast<int>(std::lround(std::cbrt(grains / 1.1))));
  return {side, side, std::max(3, static_cast<int>(std::lround(static_cast<double>(grains) / (side * side))))};
}

class Bench {
 public:
  Bench(const std::string& engine, int grains) : engine_(make_engine(engine, log())) {
    SampleSpecification specification{"bench", {}, {0.78, 1.0, 1}};
    specification.recipe.packing.counts = lattice_of(grains);
    specification.recipe.stress_tolerance = 5e-3;
    const FoundSample found =
        find_sample(*engine_, specification, sample_cache_folder(), ProgressStyle::of_stderr(mpi_rank()));
    grains_ = found.sample.assembly.size();
    contacts_ = found.sample.assembly.contacts.size();
    assembly_ = found.sample.assembly;
  }

  /// Every benchmark starts from the same state.
  void restart() {
    sample_.emplace(*engine_, assembly_, EngineSettings{Material{}, 5e-6, 0.0});
    sample_->start_linear_velocity_field(shear_rate);
    sample_->strain({{shear_rate, 0.0}, 10 * steps_per_round, 5e-6});
  }

  void steps(benchmark::State& state) {
    restart();
    for (auto _ : state) engine_->run(steps_per_round);
    report(state);
  }
  void steps_and_exchange(benchmark::State& state) {
    restart();
    for (auto _ : state) benchmark::DoNotOptimize(sample_->strain({{shear_rate, 0.0}, steps_per_round, 5e-6}));
    report(state);
  }
  void exchange(benchmark::State& state) {
    restart();
    for (auto _ : state) benchmark::DoNotOptimize(sample_->strain({{shear_rate, 0.0}, 0, 5e-6}));
    report(state, 0);
  }

 private:
  static std::string log() { return (std::filesystem::temp_directory_path() / "flowslide_bench.log").string(); }
  void report(benchmark::State& state, int steps = steps_per_round) {
    const double done = static_cast<double>(state.iterations()) * steps;
    if (steps > 0) state.counters["steps/s"] = benchmark::Counter(done, benchmark::Counter::kIsRate);
    state.counters["grains"] = static_cast<double>(grains_);
    state.counters["contacts"] = static_cast<double>(contacts_);
    state.counters["ranks"] = mpi_ranks();
  }

  std::unique_ptr<Engine> engine_;
  Assembly assembly_;
  std::optional<DemSample> sample_;
  std::size_t grains_ = 0, contacts_ = 0;
};

/// Shows results on the first rank alone.
class Silent : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>&) override {}
};

std::string option(int& argc, char** argv, const char* name, const char* otherwise) {
  for (int i = 1; i + 1 < argc; ++i)
    if (std::strcmp(argv[i], name) == 0) {
      const std::string value = argv[i + 1];
      std::copy(argv + i + 2, argv + argc, argv + i);
      argc -= 2;
      return value;
    }
  return otherwise;
}

int run(int argc, char** argv) {
  const std::string engine = option(argc, argv, "--engine", "liggghts");
  const int grains = std::atoi(option(argc, argv, "--grains", "1100").c_str());
  if (grains < 27) throw ConfigurationError(fmt::format("--grains is {}; allowed: at least 27", grains));
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return to_int(ExitCode::configuration);
  Bench bench(engine, grains);
  // All ranks step together, so each benchmark runs a fixed number of times.
  const int rounds = std::max(20, 200'000 / grains);
  const auto add = [&](const char* name, void (Bench::*what)(benchmark::State&)) {
    benchmark::RegisterBenchmark(name, [&bench, what](benchmark::State& state) { (bench.*what)(state); })
        ->Unit(benchmark::kMicrosecond)
        ->Iterations(rounds)
        ->Repetitions(5)
        ->ReportAggregatesOnly(true)
        ->UseRealTime();
  };
  add("10 steps", &Bench::steps);
  add("10 steps, 1 exchange", &Bench::steps_and_exchange);
  add("1 exchange", &Bench::exchange);
  Silent silent;
  if (mpi_rank() == 0)
    benchmark::RunSpecifiedBenchmarks();
  else
    benchmark::RunSpecifiedBenchmarks(&silent);
  return to_int(ExitCode::ok);
}

}  // namespace

int main(int argc, char** argv) {
  return run_main([&] { return run(argc, argv); }, mpi_rank());
}
