// SPDX-License-Identifier: GPL-2.0-or-later
// thread_bench [--engine E] [--grains N] [--threads N] [--rounds N] [--seconds S]
// What several threads can gain on this machine. Each round measures, one after the other and so in the same minute:
// the time of a message between two cores; one run on one thread; one run on all threads; and as many independent runs
// side by side as there are threads. The independent runs share no grain: they are the limit of any division of one
// run.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include "bench_options.hpp"
#include "bench_states.hpp"
#include "dem/make_engine.hpp"
#include "experiment/ensemble.hpp"
#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"
#include "program/run_main.hpp"
#include "sample/dem_sample.hpp"

namespace {

using namespace flowslide;
using Clock = std::chrono::steady_clock;

constexpr double time_step = 5e-7;  // s, the paper's
constexpr int steps_at_once = 100;
constexpr int messages = 20'000;  ///< of one measurement, each from a core to the other and back
/// A message that takes longer than this passes a cache that the two cores do not share, ns.
constexpr double long_message = 80.0;

struct Options {
  std::string engine = "native";
  int grains = 8800, threads = 2, rounds = 30;
  double seconds = 0.2;
};

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Time of a message from one thread to another, ns: half the time of a message and its answer. Both threads spin.
double message_time() {
  std::atomic<int> sent{0};
  std::thread other([&] {
    for (int i = 0; i < messages; ++i) {
      while (sent.load(std::memory_order_acquire) != 2 * i + 1) {}
      sent.store(2 * i + 2, std::memory_order_release);
    }
  });
  const auto start = Clock::now();
  for (int i = 0; i < messages; ++i) {
    while (sent.load(std::memory_order_acquire) != 2 * i) {}
    sent.store(2 * i + 1, std::memory_order_release);
  }
  other.join();
  return 0.5e9 * seconds_since(start) / messages;
}

/// A sample on an engine with this number of threads, and its speed.
class Runner {
 public:
  Runner(const BenchState& state, const std::string& engine, int threads)
      : sample_(make_engine(engine, std::filesystem::temp_directory_path() / "flowslide_bench.log", threads),
                state.assembly, EngineSettings{Material{}, time_step, 0.0}) {}
  /// Runs for about this time. Returns steps per second.
  double speed(double seconds) {
    const auto start = Clock::now();
    std::int64_t steps = 0;
    do {
      sample_.strain({{0.0, 0.0}, steps_at_once, time_step});
      steps += steps_at_once;
    } while (seconds_since(start) < seconds);
    return static_cast<double>(steps) / seconds_since(start);
  }

 private:
  DemSample sample_;
};

double speed_side_by_side(std::vector<std::unique_ptr<Runner>>& runners, double seconds) {
  std::vector<double> speeds(runners.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < runners.size(); ++i)
    threads.emplace_back([&, i] { speeds[i] = runners[i]->speed(seconds); });
  for (std::thread& thread : threads) thread.join();
  double sum = 0.0;
  for (const double speed : speeds) sum += speed;
  return sum;
}

struct Round {
  double message, alone, together, side_by_side;  ///< ns; steps/s
};

void print(const char* which, const std::vector<Round>& rounds) {
  if (rounds.empty()) return;
  const auto median = [&](auto value) {
    std::vector<double> values;
    for (const Round& round : rounds) values.push_back(value(round));
    return statistics_of(values).median;
  };
  fmt::print("| {} | {} | {:.0f} | {:.3g} | {:.2f} | {:.2f} |\n", which, rounds.size(),
             median([](const Round& r) { return r.message; }), median([](const Round& r) { return r.alone; }),
             median([](const Round& r) { return r.together / r.alone; }),
             median([](const Round& r) { return r.side_by_side / r.alone; }));
}

int run(int argc, char** argv) {
  Options options;
  CLI::App app("What several threads can gain on this machine, beside independent runs");
  app.add_option("--engine", options.engine)->check(CLI::IsMember({"native", "native-mixed"}));
  app.add_option("--grains", options.grains)->check(CLI::Range(27, 10'000'000));
  app.add_option("--threads", options.threads)->check(CLI::Range(2, 1024));
  app.add_option("--rounds", options.rounds)->check(CLI::Range(1, 100'000));
  app.add_option("--seconds", options.seconds, "of each measurement")->check(CLI::Range(1e-3, 60.0));
  parse_options(app, argc, argv);
  const BenchState state = bench_state("rest", options.grains);
  Runner alone(state, options.engine, 1), together(state, options.engine, options.threads);
  std::vector<std::unique_ptr<Runner>> independent;
  for (int i = 0; i < options.threads; ++i) independent.push_back(std::make_unique<Runner>(state, options.engine, 1));
  std::vector<Round> near, far;
  for (int i = 0; i < options.rounds; ++i) {
    Round round{message_time(), alone.speed(options.seconds), together.speed(options.seconds),
                speed_side_by_side(independent, options.seconds)};
    round.message = std::max(round.message, message_time());  // the state of the machine may have changed meanwhile
    (round.message < long_message ? near : far).push_back(round);
  }
  fmt::print(
      "| {} grains, {} | rounds | message (ns) | steps/s of one thread | {} threads over one | {} independent runs "
      "over one |\n|---|---|---|---|---|---|\n",
      state.assembly.size(), options.engine, options.threads, options.threads);
  print("cores share a cache", near);
  print("cores share no cache", far);
  return to_int(ExitCode::ok);
}

}  // namespace

int main(int argc, char** argv) {
  return run_main([&] { return run(argc, argv); }, mpi_rank());
}
