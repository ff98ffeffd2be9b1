// SPDX-License-Identifier: GPL-2.0-or-later
// sample_bench [--grains N,N] [--rounds N]: what each call of a DemSample costs on one thread of the native engine, in
// double, with the time step of the paper. Prints the machine and a table in Markdown (docs/library.md).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <fstream>
#include <functional>
#include <iostream>
#include <limits>
#include <memory>

#include "bench_states.hpp"
#include "configuration/error.hpp"
#include "dem/native/native_engine.hpp"
#include "program/run_main.hpp"
#include "sample/dem_sample.hpp"

namespace flowslide {
namespace {

constexpr double time_step = 5e-7;  // s, the paper's
constexpr int short_run = 10;       // steps
constexpr int exchanges = 50;       // short runs that are compared with one run of as many steps

/// Shortest wall time of `call` in `rounds`, s.
double shortest(int rounds, const std::function<void()>& call) {
  using Clock = std::chrono::steady_clock;
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    const auto start = Clock::now();
    call();
    least = std::min(least, std::chrono::duration<double>(Clock::now() - start).count());
  }
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

  const double as_one = shortest(rounds, [&] { strain(exchanges * short_run); });
  const double in_parts = shortest(rounds, [&] {
    for (int part = 0; part < exchanges; ++part) strain(short_run);
  });
  const double step = as_one / (exchanges * short_run);
  const SampleState kept = sample->state();
  const auto row = [&](const char* call, double seconds) {
    fmt::print("| {} | {} | {:.3g} us | {:.3g} |\n", state.assembly.size(), call, 1e6 * seconds, seconds / step);
  };
  row("one step of `strain`", step);
  row("one `strain` besides its steps", (in_parts - as_one) / (exchanges - 1));
  row("`state`", shortest(rounds, [&] { sample->state(); }));
  row("`restore`", shortest(rounds, [&] { sample->restore(kept); }));
  row("construction", shortest(rounds, [&] { new_sample(); }));
  row("`mean_stress`", shortest(rounds, [&] { sample->mean_stress(); }));
  row("`assembly`", shortest(rounds, [&] { sample->assembly(); }));
  fmt::print("\n{} contacts; a state has {:.3g} MB.\n\n", kept.grains->contacts.size(), 1e-6 * bytes_of(*kept.grains));
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
  app.add_option("--rounds", rounds, "of which the shortest counts")->check(CLI::Range(1, 10'000));
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw FinishedEarly(app.help());
  } catch (const CLI::ParseError& error) {
    throw ConfigurationError(error.what());
  }
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
