// SPDX-License-Identifier: GPL-2.0-or-later
// engine_bench [--engines A,B] [--grains N,N] [--states A,B] [--threads N] [--rounds N] [Google Benchmark's options]
// Times steps of prepared samples at the paper's dt_L, with an exchange (steering the boundaries, reading the stress,
// counting grains) every ten of them. Repetitions of all engines alternate, so that they share what the machine does.
// Samples come from the cache and are prepared if they are not there. --benchmark_out=FILE writes JSON.
#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "bench_options.hpp"
#include "bench_states.hpp"
#include "bench_table.hpp"
#include "configuration/error.hpp"
#include "dem/make_engine.hpp"
#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"
#include "program/run_main.hpp"
#include "sample/dem_sample.hpp"

namespace {

using namespace flowslide;

constexpr double time_step = 5e-7;  // s, the paper's
constexpr int steps_per_exchange = 10, exchanges_per_round = 10, warm_rounds = 5;
constexpr std::int64_t least_exchange_turns = 5;  // each a round with ten exchanges and a round with one

/// One engine with one state, at the start of each repetition.
class Bench {
 public:
  Bench(const BenchState& state, const std::string& engine, int threads, std::size_t place)
      : state_(state), engine_name_(engine), threads_(threads), place_(place) {}

  void run(benchmark::State& timed) {
    start();
    for (auto _ : timed)
      for (int e = 0; e < exchanges_per_round; ++e) benchmark::DoNotOptimize(strain(steps_per_exchange));
    const double steps = static_cast<double>(timed.iterations()) * steps_per_exchange * exchanges_per_round;
    timed.counters["steps/s"] = benchmark::Counter(steps, benchmark::Counter::kIsRate);
    timed.counters["grains"] = static_cast<double>(state_.assembly.size());
    timed.counters["contacts"] = static_cast<double>(contacts_);
    timed.counters["workers"] = engine_name_ == "liggghts" ? mpi_ranks() : threads_;
    timed.counters["place"] = static_cast<double>(place_);
    timed.counters["exchange share"] = exchange_share(std::max<std::int64_t>(timed.iterations(), least_exchange_turns));
  }

 private:
  using Clock = std::chrono::steady_clock;
  CellStress strain(int steps) { return sample_->strain({{state_.shear_rate, 0.0}, steps, time_step}); }

  void start() {
    const auto log = std::filesystem::temp_directory_path() / "flowslide_bench.log";
    sample_.emplace(make_engine(engine_name_, log, threads_, all_ranks()), state_.assembly,
                    EngineSettings{Material{}, time_step, 0.0});
    if (state_.name == "shear") sample_->start_linear_velocity_field(state_.shear_rate);
    for (int round = 0; round < warm_rounds; ++round) strain(steps_per_exchange * exchanges_per_round);
    contacts_ = sample_->assembly().contacts.size();
  }

  /// What exchanges add to the time: rounds with ten against rounds with one, by turns, the fastest of each.
  double exchange_share(std::int64_t turns) {
    double with = 1e300, without = 1e300;
    for (std::int64_t turn = 0; turn < turns; ++turn) {
      const auto start = Clock::now();
      for (int e = 0; e < exchanges_per_round; ++e) strain(steps_per_exchange);
      const auto middle = Clock::now();
      strain(steps_per_exchange * exchanges_per_round);
      with = std::min(with, std::chrono::duration<double>(middle - start).count());
      without = std::min(without, std::chrono::duration<double>(Clock::now() - middle).count());
    }
    return (with - without) / with * exchanges_per_round / (exchanges_per_round - 1);
  }

  const BenchState& state_;
  std::string engine_name_;
  int threads_;
  std::size_t place_;  ///< in the table
  std::optional<DemSample> sample_;
  std::size_t contacts_ = 0;
};

/// The engines of this build, without the variant of LIGGGHTS that keeps histories.
std::vector<std::string> measured_engines() {
  std::vector<std::string> names = engine_names_of_build();
  std::erase(names, "liggghts-stock");
  return names;
}

struct Options {
  std::vector<std::string> engines = measured_engines(), states = bench_state_names();
  std::vector<int> grains{1100, 8800};
  int threads = 1, rounds = 0;
};

/// Options of this program. The rest goes to Google Benchmark. Repetitions alternate unless its options say otherwise.
Options read_options(int argc, char** argv) {
  Options options;
  CLI::App app("Times of DEM engines side by side");
  app.add_option("--engines", options.engines)->delimiter(',')->check(CLI::IsMember(engine_names_of_build()));
  app.add_option("--grains", options.grains)->delimiter(',')->check(CLI::Range(27, 10'000'000));
  app.add_option("--states", options.states)->delimiter(',')->check(CLI::IsMember(bench_state_names()));
  app.add_option("--threads", options.threads, "of the native engines")->check(CLI::Range(1, 1024));
  app.add_option("--rounds", options.rounds, "of 100 steps a repetition; 0: as suits the size")
      ->check(CLI::Range(0, 1'000'000));
  app.allow_extras();
  parse_options(app, argc, argv);
  std::vector<std::string> rest = app.remaining();
  // By turns in an order that is drawn, unless several ranks would each draw their own and wait for one another.
  const char* turns = mpi_ranks() == 1 ? "true" : "false";
  rest.insert(rest.begin(), {argv[0], "--benchmark_repetitions=7",
                             fmt::format("--benchmark_enable_random_interleaving={}", turns)});
  std::vector<char*> words;
  for (std::string& word : rest) words.push_back(word.data());
  int count = static_cast<int>(words.size());
  benchmark::Initialize(&count, words.data());
  if (count > 1) throw ConfigurationError(fmt::format("unknown option '{}'; see --help", words[1]));
  return options;
}

int run(int argc, char** argv) {
  const Options options = read_options(argc, argv);
  std::vector<std::unique_ptr<BenchState>> states;
  std::vector<std::unique_ptr<Bench>> benches;
  for (const int grains : options.grains)
    for (const std::string& name : options.states) {
      const BenchState& state = *states.emplace_back(std::make_unique<BenchState>(bench_state(name, grains)));
      for (const std::string& engine : options.engines) {
        Bench* bench =
            benches.emplace_back(std::make_unique<Bench>(state, engine, options.threads, benches.size())).get();
        // All ranks step together, so each runs a fixed number of times: some 0.2 s.
        const int rounds =
            std::max(1, (engine == "liggghts" ? 20'000 : 100'000) / static_cast<int>(state.assembly.size()));
        benchmark::RegisterBenchmark((name + "/" + engine).c_str(), [bench](benchmark::State& s) { bench->run(s); })
            ->Iterations(options.rounds > 0 ? options.rounds : rounds)
            ->UseRealTime();
      }
    }
  BenchTable table(mpi_rank() != 0);
  benchmark::RunSpecifiedBenchmarks(&table);
  return to_int(ExitCode::ok);
}

}  // namespace

int main(int argc, char** argv) {
  return run_main([&] { return run(argc, argv); }, mpi_rank());
}
