// SPDX-License-Identifier: GPL-2.0-or-later
// Four samples in one program, each strained by its own history, as a host with many material points does. With MPI the
// ranks share the samples out, and the numbers stay the same. One sample is kept in memory half-way; a second object
// restores it and repeats the second half with the same bits.
#include <array>
#include <cstdio>
#include <flowslide/dem/native/native_engine.hpp>
#include <flowslide/sample/dem_sample.hpp>
#include <flowslide/sample/preparation.hpp>
#include <map>
#include <memory>
#ifdef WITH_MPI
#include <mpi.h>
#endif

using namespace flowslide;

namespace {

constexpr int samples = 4, exchanges = 30, kept_sample = 2, half = exchanges / 2;
constexpr double time_step = 1e-5;  // s

/// The strain of sample k in exchange i: the shear alternates, and its rate and the compression differ.
LocalRun history(int k, int i) {
  const double direction = i / 10 % 2 == 0 ? 1.0 : -1.0;
  return {{.shear = direction * 0.2 * (k + 1), .compression = 0.001 * k}, 100, time_step};
}

struct Ranks {
  int rank = 0, count = 1;
#ifdef WITH_MPI
  Ranks() {
    MPI_Init(nullptr, nullptr);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &count);
  }
  ~Ranks() { MPI_Finalize(); }
  /// Sums over the ranks, on the first.
  template <std::size_t n>
  void sum(std::array<double, n>& values) const {
    std::array<double, n> all{};
    MPI_Reduce(values.data(), all.data(), n, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
    values = all;
  }
#else
  template <std::size_t n>
  void sum(std::array<double, n>&) const {}
#endif
};

bool same_bits(const SampleState& a, const SampleState& b) {
  bool same = a.grains->position == b.grains->position && a.grains->velocity == b.grains->velocity;
  for (const auto& [name, value] : a.numbers) same = same && (name == "processor_seconds" || b.number(name) == value);
  return same;
}

}  // namespace

int main() {
  const Ranks ranks;
  SampleRecipe recipe;
  recipe.packing.counts = {5, 5, 6};
  recipe.compaction_rate = 2.0;
  recipe.stress_tolerance = 5e-3;
  const NativeOptions one_thread{.threads = 1};
  DoubleEngine preparing(one_thread);
  const PreparedSample prepared = prepare_sample(preparing, recipe);  // the same bits on every rank
  const auto new_sample = [&] {
    return std::make_unique<DemSample>(std::make_unique<DoubleEngine>(one_thread), prepared.assembly,
                                       EngineSettings{recipe.material, time_step, 0.0});
  };

  std::map<int, std::unique_ptr<DemSample>> mine;
  for (int k = ranks.rank; k < samples; k += ranks.count) mine[k] = new_sample();
  SampleState kept;
  for (int i = 0; i < exchanges; ++i)
    for (auto& [k, sample] : mine) {
      if (k == kept_sample && i == half) kept = sample->state();
      sample->strain(history(k, i));
    }

  std::array<double, 3 * samples + 1> results{};  // gamma, tau and sigma of each sample; whether the bits are the same
  for (const auto& [k, sample] : mine) {
    results[3 * k] = sample->shear_strain();
    results[3 * k + 1] = sample->stress().shear;
    results[3 * k + 2] = sample->stress().normal;
  }
  if (mine.contains(kept_sample)) {
    const auto restored = new_sample();
    restored->restore(kept);
    for (int i = half; i < exchanges; ++i) restored->strain(history(kept_sample, i));
    results.back() = same_bits(restored->state(), mine[kept_sample]->state()) ? 1.0 : 0.0;
  }
  ranks.sum(results);
  if (ranks.rank != 0) return 0;
  std::printf("# sample  gamma  tau (Pa)  sigma (Pa)\n");
  for (int k = 0; k < samples; ++k)
    std::printf("%d  %.4f  %.17g  %.17g\n", k, results[3 * k], results[3 * k + 1], results[3 * k + 2]);
  std::printf("# sample %d restored: %s\n", kept_sample, results.back() == 1.0 ? "the same bits" : "OTHER BITS");
  return results.back() == 1.0 ? 0 : 1;
}
