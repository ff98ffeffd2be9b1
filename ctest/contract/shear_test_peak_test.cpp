// SPDX-License-Identifier: GPL-2.0-or-later
// Undrained simple shear of one prepared sample on every engine, through the peak of the shear stress.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "dem/make_engine.hpp"
#include "sample/dem_sample.hpp"
#include "sample/preparation.hpp"

namespace flowslide::shear_test_peak_test {
namespace {

constexpr double step = 1e-5, rate = 0.3;  // s, 1/s: as at quick scale

/// The same loose packing of any seed, prepared by the native engine in double.
Assembly prepared(std::uint64_t seed) {
  SampleRecipe recipe;
  recipe.packing.counts = {7, 7, 8};
  recipe.packing.seed = seed;
  recipe.preparation_friction = 0.5;
  recipe.drag = 0.06;
  recipe.compaction_rate = 2.0;
  recipe.stress_tolerance = 5e-3;
  const auto engine = make_engine("native", "/dev/null");
  return prepare_sample(*engine, recipe).assembly;
}

struct Peak {
  double stress = 0.0, strain = 0.0;  ///< Pa; gamma
};

Peak peak_of(const Assembly& assembly, const std::string& name) {
  const auto engine = make_engine(name, testing::TempDir() + "shear_test_peak.log");
  DemSample sample(*engine, assembly, {Material{}, step, 0.0});
  sample.start_linear_velocity_field(rate);
  Peak peak;
  while (sample.shear_strain() < 0.015) {
    const double stress = sample.strain({{rate, 0.0}, 50, step}).shear;
    if (stress > peak.stress) peak = {stress, sample.shear_strain()};
  }
  return peak;
}

TEST(ElementTestPeak, IsThatOfLiggghtsWithinTheSpreadOfReplicates) {
  std::map<std::string, std::vector<double>> peaks;
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Assembly assembly = prepared(seed);
    for (const std::string& name : engine_names()) {
      const Peak peak = peak_of(assembly, name);
      peaks[name].push_back(peak.stress);
      std::printf("seed %d %-14s peak %.6g Pa at %.4f %%\n", static_cast<int>(seed), name.c_str(), peak.stress,
                  100.0 * peak.strain);
    }
  }
  const std::vector<double>& reference = peaks["liggghts"];
  const auto [lowest, highest] = std::minmax_element(reference.begin(), reference.end());
  // Rounding has grown by then: in a sample this small the peak feels single slips. A fifth of the spread is far below
  // what any figure resolves.
  const double allowed = 0.2 * (*highest - *lowest);
  for (const auto& [name, stresses] : peaks)
    for (std::size_t k = 0; k < stresses.size(); ++k) EXPECT_NEAR(stresses[k], reference[k], allowed) << name;
}

}  // namespace
}  // namespace flowslide::shear_test_peak_test
