// SPDX-License-Identifier: GPL-2.0-or-later
// sample_bench [--grains N,N] [--rounds N]: what each call of a DemSample costs on one thread of the native engine, in
// double, with the time step of the paper. Prints the machine and a table in Markdown (docs/library.md).
#include <fmt/format.h>
#include <time.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>
#include <vector>

#include "bench_options.hpp"
#include "bench_states.hpp"
#include "dem/native/native_engine.hpp"
#include "program/run_main.hpp"
#include "sample/dem_sample.hpp"

namespace flowslide {
namespace {

constexpr double time_step = 5e-7;  // s, the paper's
constexpr int short_run = 10;       // steps
constexpr int turns_per_round = 8;  // of runs, which are the shortest calls
constexpr int exchanges = 10;       // short runs that are compared with one run of as many steps

/// Processor time of one `call`, s. Other programs on the machine disturb it less than wall time.
double time_of(const std::function<void()>& call) {
  const auto now = [] {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
  };
  const double start = now();
  call();
  return now() - start;
}

/// Shortest processor time of `call` in `rounds`, s.
double shortest(int rounds, const std::function<void()>& call) {
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) least = std::min(least, time_of(call));
  return least;
}

/// Size of a state in memory, bytes.
std::size_t bytes_of(const Assembly& grains) {
  return grains.size() * (sizeof(double) + 5 * sizeof(Vector3) + sizeof(Role)) +
         grains.contacts.size() * sizeof(ContactHistory);
}

void measure(int grains, int rounds) {
  const BenchState state = bench_state("shear", grains);
  const EngineSettings settings{Material{}, time_step, 0.0};
  const auto new_sample = [&] {
    return std::make_unique<DemSample>(std::make_unique<DoubleEngine>(NativeOptions{.threads = 1}), state.assembly,
                                       settings);
  };
  const auto sample = new_sample();
  sample->start_linear_velocity_field(state.shear_rate);
  const auto strain = [&](int steps) { sample->strain({{state.shear_rate, 0.0}, steps, time_step}); };
  strain(20 * short_run);

  double shortest_run = std::numeric_limits<double>::infinity();
  std::vector<double> exchange;  // of each turn, s
  for (int turn = 0; turn < turns_per_round * rounds; ++turn) {
    const double as_one = time_of([&] { strain(exchanges * short_run); });
    const double in_parts = time_of([&] {
      for (int part = 0; part < exchanges; ++part) strain(short_run);
    });
    shortest_run = std::min(shortest_run, as_one);
    exchange.push_back((in_parts - as_one) / (exchanges - 1));
  }
  const auto middle = exchange.begin() + static_cast<std::ptrdiff_t>(exchange.size() / 2);
  std::nth_element(exchange.begin(), middle, exchange.end());
  const double step = shortest_run / (exchanges * short_run);
  const SampleState kept = sample->state();
  const auto row = [&](const char* call, double seconds) {
    fmt::print("| {} | {} | {:.3g} us | {:.3g} |\n", state.assembly.size(), call, 1e6 * seconds, seconds / step);
  };
  row("one step of `strain`", step);
  row("one `strain` besides its steps", *middle);
  row("`state`", shortest(rounds, [&] { sample->state(); }));
  row("`restore`", shortest(rounds, [&] { sample->restore(kept); }));
  row("construction", shortest(rounds, [&] { new_sample(); }));
  row("`mean_stress`", shortest(rounds, [&] { sample->mean_stress(); }));
  row("`assembly`", shortest(rounds, [&] { sample->assembly(); }));
  fmt::print("\n{} contacts; a state has {:.3g} MB.\n\n", kept.grains->contacts.size(),
             1e-6 * static_cast<double>(bytes_of(*kept.grains)));
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

int run(int argc, char** argv) {
  std::vector<int> grains{1100, 8800};
  int rounds = 25;
  CLI::App app("Cost of the calls of a sample");
  app.add_option("--grains", grains)->delimiter(',')->check(CLI::Range(27, 20'000));
  app.add_option("--rounds", rounds, "of which the shortest counts; 8 times as many of runs")
      ->check(CLI::Range(1, 10'000));
  parse_options(app, argc, argv);
  fmt::print("{}, one thread:\n\n", processor());
  for (const int number : grains) {
    fmt::print("| grains | call | time | in steps |\n|---|---|---|---|\n");
    measure(number, rounds);
  }
  return to_int(ExitCode::ok);
}

}  // namespace
}  // namespace flowslide

int main(int argc, char** argv) {
  return flowslide::run_main([&] { return flowslide::run(argc, argv); }, 0);
}
