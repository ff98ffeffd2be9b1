// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <tuple>

namespace flowslide {
namespace {

/// What the ports of an AVX-512 core at 2.95 GHz need at least, ns per contact and step, by counted instructions.
constexpr double floor_double = 6.7, floor_mixed = 4.9;
/// Gain of a LIGGGHTS with this contact model compiled in, -O3 and native flags, over Debian's.
constexpr double tuned_liggghts = 1.10;

std::string times(double ratio, bool known) { return known ? fmt::format("{:.1f}", ratio) : "-"; }

}  // namespace

bool BenchTable::ReportContext(const Context&) { return true; }

void BenchTable::ReportRuns(const std::vector<Run>& runs) {
  for (const Run& run : runs) {
    if (run.run_type != Run::RT_Aggregate || run.aggregate_name != "median") continue;
    const auto value = [&](const char* name) {
      const auto found = run.counters.find(name);
      return found == run.counters.end() ? 0.0 : static_cast<double>(found->second);
    };
    const std::string& name = run.run_name.function_name;
    const std::size_t slash = name.find('/');
    const double steps = value("steps/s");
    rows_.push_back({name.substr(0, slash), name.substr(slash + 1), value("grains"), value("contacts"),
                     value("workers"), steps, 1e9 / (steps * value("contacts")), value("exchange share"),
                     value("place")});
  }
}

const BenchTable::Row* BenchTable::liggghts_for(const Row& row) const {
  for (const Row& other : rows_)
    if (other.engine == "liggghts" && other.state == row.state && other.grains == row.grains &&
        other.workers == row.workers)
      return &other;
  return nullptr;
}

void BenchTable::Finalize() {
  if (quiet_) return;
  // Repetitions alternate, so that results come in any order.
  std::stable_sort(rows_.begin(), rows_.end(), [](const Row& a, const Row& b) {
    return std::tie(a.grains, a.place) < std::tie(b.grains, b.place);
  });
  fmt::print(
      "| N | state | contacts | engine | cores | steps/s | ns per contact and step | grain steps/s | exchanges | "
      "x LIGGGHTS | x tuned LIGGGHTS | share of the floor |\n");
  fmt::print("|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows_) {
    const Row* reference = liggghts_for(row);
    const double ratio = reference ? row.steps_per_second / reference->steps_per_second : 0.0;
    const bool native = row.engine.starts_with("native"), mixed = row.engine == "native-mixed";
    const double least = (mixed ? floor_mixed : floor_double) / row.workers;
    fmt::print("| {:.0f} | {} | {:.0f} | {} | {:.0f} | {:.3g} | {:.1f} | {:.3g} | {:.1f} % | {} | {} | {} |\n",
               row.grains, row.state, row.contacts, row.engine, row.workers, row.steps_per_second, row.cost,
               row.grains * row.steps_per_second, 100.0 * row.exchange_share, times(ratio, reference),
               times(ratio / tuned_liggghts, reference && native),
               native ? fmt::format("{:.0f} %", 100.0 * least / row.cost) : "-");
  }
  std::fflush(stdout);
}

}  // namespace flowslide
