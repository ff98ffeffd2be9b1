// SPDX-License-Identifier: GPL-2.0-or-later
// A sample that continues from a stored state, on every engine, and again on two MPI ranks.
#include <gtest/gtest.h>

#include <cmath>

#include "dem/make_engine.hpp"
#include "process/mpi_session.hpp"
#include "sample/dem_sample.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::restart_contract_test {
namespace {

constexpr double step = 2e-6;

/// In stress, relative: what some 200 steps, before chaos sets in, make of the rounding of a state by LIGGGHTS. The
/// native engine promises the same bits.
double tolerance(const std::string& engine) { return engine.starts_with("native") ? 0.0 : 1e-12; }

class RestartContract : public testing::TestWithParam<std::string> {
 protected:
  std::unique_ptr<Engine> engine() const {
    return make_engine(GetParam(), testing::TempDir() + "restart_contract." + GetParam() + ".log", 0, all_ranks());
  }
  static DemSample sample_on(Engine& engine) {
    return DemSample(engine, touching_lattice(), {Material{}, step, 0.0});
  }
  /// Exchanges of different rates and time steps.
  static void strain(Sample& sample, int from, int to) {
    for (int i = from; i < to; ++i)
      sample.strain({{3.0 + i, 0.1 * i}, 20 + i, (i % 2 ? 1.0 : 0.7) * step});
  }
};

TEST_P(RestartContract, GoesOnFromAStoredState) {
  const auto first = engine();
  DemSample whole = sample_on(*first);
  strain(whole, 0, 5);
  const SampleState state = whole.state();
  strain(whole, 5, 12);
  const CellStress expected = whole.stress();
  const auto second = engine();
  DemSample other = sample_on(*second);
  other.restore(state);
  strain(other, 5, 12);
  for (const auto part : {&CellStress::normal, &CellStress::shear, &CellStress::lateral_x, &CellStress::lateral_y})
    EXPECT_LE(std::abs(other.stress().*part - expected.*part), tolerance(GetParam()) * std::abs(expected.normal))
        << other.stress().*part << " is not " << expected.*part;
  EXPECT_EQ(other.time(), whole.time());
  EXPECT_EQ(other.steps(), whole.steps());
  EXPECT_EQ(other.shear_strain(), whole.shear_strain());
  EXPECT_NE(expected.shear, state.number("shear_stress"));  // the strain has changed it
}

INSTANTIATE_TEST_SUITE_P(Engines, RestartContract, testing::ValuesIn(engine_names_of_build()),
                         [](const testing::TestParamInfo<std::string>& tested) {
                           std::string name = tested.param;
                           for (char& c : name)
                             if (c == '-') c = '_';
                           return name;
                         });

}  // namespace
}  // namespace flowslide::restart_contract_test
