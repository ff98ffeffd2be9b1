// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <benchmark/benchmark.h>

#include <ostream>
#include <string>
#include <vector>

namespace flowslide {

/// Collects what Google Benchmark has timed and prints it as one table in Markdown: medians of the repetitions, and
/// ratios to LIGGGHTS in the same state with as many ranks as the others have threads.
class BenchTable : public benchmark::BenchmarkReporter {
 public:
  /// `quiet`: prints nothing, as on all MPI ranks but the first.
  explicit BenchTable(bool quiet) : quiet_(quiet) {}
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;
  void Finalize() override;

 private:
  struct Row {
    std::string state, engine;
    double grains, contacts, workers, steps_per_second, cost;  ///< cost: ns per contact and step
    double exchange_share;                                     ///< of the time, with one every ten steps
    double place;                                              ///< in the order of the benchmarks
  };
  const Row* liggghts_for(const Row& row) const;
  bool quiet_;
  std::vector<Row> rows_;
};

}  // namespace flowslide
