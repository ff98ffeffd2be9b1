// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/shear_test.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dem/make_engine.hpp"
#include "grains/measures.hpp"
#include "record/same_bits.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

constexpr double time_step = 2e-6;  // a tenth of the Rayleigh time of the lattice's grains

TEST(ShearTestSteps, ReachTheFinalStrain) {
  EXPECT_EQ((ShearTest{0.06, 0.5, 500}.steps(5e-7)), 16'666'667);  // 0.5 / (0.06 * 5e-7) = 16 666 666.7
  EXPECT_EQ((ShearTest{0.25, 0.5, 500}.steps(1e-5)), 200'000);
  EXPECT_EQ((ShearTest{1.0, 1e-9, 500}.steps(1e-5)), 1);  // not none
}

TEST(ShearTestSteps, RefuseMoreThanCanBeCounted) {
  // 0.5 / (1e-20 * 5e-7) = 1e26 steps: beyond 64 bits, where rounding would make one step of them.
  EXPECT_THROW((ShearTest{1e-20, 0.5, 500}.steps(5e-7)), std::invalid_argument);
  EXPECT_THROW((ShearTest{0.0, 0.5, 500}.steps(5e-7)), std::invalid_argument);
}

TEST(ShearTestRows, IncreaseFromZeroToTheLastStep) {
  for (const ShearTest& test : {ShearTest{0.06, 0.5, 500}, ShearTest{0.2, 0.5, 300}, ShearTest{1.0, 0.01, 500},
                                  ShearTest{1.0, 1e-9, 10}}) {
    const auto rows = test.row_steps(1e-5);
    EXPECT_EQ(rows.front(), 0);
    EXPECT_EQ(rows.back(), test.steps(1e-5));
    EXPECT_TRUE(std::adjacent_find(rows.begin(), rows.end(), std::greater_equal<>()) == rows.end());
    EXPECT_LE(rows.size(), static_cast<std::size_t>(test.rows) + 1);
  }
}

TEST(ShearTestRows, StandAtTheSquaresOfTheirNumbers) {
  const ShearTest test{1.0, 1.0, 10};
  const std::vector<std::int64_t> squares{0, 1, 4, 9, 16, 25, 36, 49, 64, 81, 100};
  EXPECT_EQ(test.row_steps(0.01), squares);  // 100 steps
  std::vector<std::int64_t> longer = squares;
  for (std::int64_t& step : longer) step *= 1000;
  EXPECT_EQ(test.row_steps(1e-5), longer);
  // Where two fall on one step, it has one row: 4 steps in 10 rows are 0.04, 0.16, ... rounded.
  EXPECT_EQ(test.row_steps(0.25), (std::vector<std::int64_t>{0, 1, 2, 3, 4}));
}

TEST(ShearTestSeries, NamesEveryColumnOnce) {
  const Series series = shear_test_series();
  EXPECT_NO_THROW(series.check());
  EXPECT_EQ(series.rows(), 0U);
  EXPECT_EQ(series.columns.size(), 12U);
  for (const char* name : {"shear_strain", "shear_stress", "normal_stress", "mean_stress", "inertial_number"})
    EXPECT_NO_THROW(series.column(name)) << name;
}

/// A short test of a small lattice, recorded once for all that is asked of it.
class RecordOfALattice : public testing::Test {
 protected:
  static constexpr double rate = 5.0;
  RecordOfALattice() {
    const auto observe = [&](std::int64_t steps, const Assembly& assembly, const ShearTestRecord& record) {
      observed_steps_.push_back(steps);
      observed_rows_.push_back(record.rows.rows());
      grains_ = assembly.size();
    };
    record_ = run_shear_test(sample_, test_, observe);
    series_ = record_.rows;
  }
  const std::vector<double>& column(const char* name) const { return series_.column(name).values; }

  /// The lattice after some steps. Like a prepared sample it then stores the forces on its grains.
  static Assembly settled(Engine& engine) {
    DemSample sample(engine, touching_lattice(), {Material{}, time_step, 0.0});
    sample.strain({{0.0, 0.0}, 20, time_step});
    return sample.assembly();
  }

  const ShearTest test_{rate, rate * 400 * time_step, 10};
  std::unique_ptr<Engine> engine_ = make_engine(engine_names_of_build().front(), testing::TempDir() + "shear_test.log");
  const Assembly lattice_ = settled(*engine_);
  DemSample sample_{*engine_, lattice_, {Material{}, time_step, 0.0}};
  const CellStress stress_before_ = sample_.stress();
  ShearTestRecord record_;
  Series series_;
  std::vector<std::int64_t> observed_steps_;
  std::vector<std::size_t> observed_rows_;
  std::size_t grains_ = 0;
};

TEST_F(RecordOfALattice, HasEveryRowAndTellsItsObserver) {
  const auto steps = test_.row_steps(time_step);
  ASSERT_EQ(steps.back(), 400);
  ASSERT_EQ(series_.rows(), steps.size());
  EXPECT_EQ(observed_steps_, steps);
  EXPECT_EQ(grains_, lattice_.size());
  for (std::size_t row = 0; row < steps.size(); ++row) {
    EXPECT_EQ(observed_rows_[row], row + 1);
    // Sums of ten products: rounding.
    EXPECT_NEAR(series_.axis.values[row], static_cast<double>(steps[row]) * time_step, 1e-15);
    EXPECT_NEAR(column("shear_strain")[row], rate * static_cast<double>(steps[row]) * time_step, 1e-15);
  }
  EXPECT_NO_THROW(series_.check());  // all finite
}

TEST_F(RecordOfALattice, HasTheStressThatBagiGives) {
  const double scale = *std::max_element(column("normal_stress").begin(), column("normal_stress").end());
  ASSERT_GT(scale, 1e3);  // it carries stress, Pa
  // Not in the first row: it has the sudden velocities, but the forces of the last step without them.
  for (std::size_t row = 1; row < series_.rows(); ++row) {
    // The same contact forces, summed over contacts and over grains and boundaries. 1e-9: rounding of sums of some
    // thousand terms that cancel in part.
    EXPECT_NEAR(column("bagi_shear_stress")[row], column("shear_stress")[row], 1e-9 * scale) << row;
    EXPECT_NEAR(column("bagi_normal_stress")[row], column("normal_stress")[row], 1e-9 * scale) << row;
  }
}

TEST_F(RecordOfALattice, BeginsWithTheStressAtRest) {
  ASSERT_GT(stress_before_.normal, 1e3);  // Pa
  // Loading the saved state changes only rounding.
  EXPECT_NEAR(column("normal_stress").front(), stress_before_.normal, 1e-12 * stress_before_.normal);
  EXPECT_NEAR(column("shear_stress").front(), stress_before_.shear, 1e-12 * stress_before_.normal);
}

TEST_F(RecordOfALattice, IsShearedDownslopeAtConstantVolume) {
  EXPECT_GT(column("shear_stress").back() - column("shear_stress").front(), 100.0);  // Pa; positive resists
  const double solid = lattice_.solid_volume();
  for (const double e : column("void_ratio")) EXPECT_NEAR(e, lattice_.cell.volume() / solid - 1.0, 1e-12);  // rounding
}

TEST_F(RecordOfALattice, HasAFiniteInertialNumberOfTheBulk) {
  for (std::size_t row = 0; row < series_.rows(); ++row) {
    const double pressure = column("mean_stress")[row], number = column("inertial_number")[row];
    ASSERT_GT(pressure, 0.0) << row;
    // I = gamma_dot D sqrt(rho / p), by hand; rounding.
    EXPECT_NEAR(number, rate * lattice_.mean_diameter() * std::sqrt(2650.0 / pressure), 1e-12 * number) << row;
    EXPECT_GE(column("kinetic_normal_stress")[row], 0.0);
  }
}

void expect_to_go_on_from_any_row(const ShearTest& test) {
  const auto start = [](Engine& engine) {
    return DemSample(engine, touching_lattice(), {Material{}, time_step, 0.0});
  };
  const auto engine = make_engine("native", "/dev/null");
  DemSample whole = start(*engine);
  const ShearTestRecord expected = run_shear_test(whole, test);
  for (const std::size_t stop : {1U, 4U, 10U}) {
    struct Enough {};
    DemSample first = start(*engine);
    ShearTestRecord kept;
    SampleState state;
    try {
      run_shear_test(first, test, [&](std::int64_t, const Assembly&, const ShearTestRecord& so_far) {
        if (so_far.rows.rows() < stop) return;
        kept = so_far;
        state = first.state();
        throw Enough{};
      });
    } catch (const Enough&) {
    }
    ASSERT_EQ(kept.rows.rows(), stop);
    const auto other = make_engine("native", "/dev/null");
    DemSample second = start(*other);
    second.restore(state);
    const ShearTestRecord record = run_shear_test(second, test, {}, kept);
    expect_same_bits(record.rows, expected.rows);
    expect_same_bits(record.measured, expected.measured);
  }
}

TEST(ShearTestRecord, GoesOnFromAnyRowWithTheSameBits) {
  expect_to_go_on_from_any_row({5.0, 5.0 * 200 * time_step, 10});
}

TEST(ShearTestRecord, GoesOnWithAdaptiveStepsWithTheSameBits) {
  expect_to_go_on_from_any_row({5.0, 5.0 * 200 * time_step, 10, 0.0, AdaptiveTimeStep{time_step, 3.0 * time_step, 7}});
}

TEST(ShearTestRecord, EndsAtTheRowThatBearsItsNormalStressAlsoWhenItGoesOn) {
  const auto engine = make_engine("native", "/dev/null");
  DemSample sample(*engine, touching_lattice(), {Material{}, time_step, 0.0});
  ShearTest test{5.0, 5.0 * 2000 * time_step, 10};
  const Series all = run_shear_test(sample, test).measured;
  const std::vector<double>& normal = all.column("normal_stress").values;
  const std::size_t largest = std::max_element(normal.begin() + 1, normal.end()) - normal.begin();
  ASSERT_GT(normal[largest], normal[0]);
  test.end_normal_stress = normal[largest];
  DemSample second(*engine, touching_lattice(), {Material{}, time_step, 0.0});
  const ShearTestRecord ended = run_shear_test(second, test);
  EXPECT_EQ(ended.measured.rows(), largest + 1);
  const std::int64_t steps = second.steps();
  const ShearTestRecord again = run_shear_test(second, test, {}, ended);
  EXPECT_EQ(second.steps(), steps);
  expect_same_bits(again.rows, ended.rows);
  expect_same_bits(again.measured, ended.measured);
}

TEST(ShearTestRecord, HasItsRowsAtTheSameStrainsWithAdaptiveSteps) {
  const auto engine = make_engine("native", "/dev/null");
  const auto run = [&](const ShearTest& test, std::int64_t& steps) {
    DemSample sample(*engine, touching_lattice(), {Material{}, time_step, 0.0});
    const Series rows = run_shear_test(sample, test).rows;
    EXPECT_NEAR(sample.shear_strain(), test.final_strain, 1e-12);
    steps = sample.steps();
    return rows;
  };
  const double strain = 5.0 * 2000 * time_step;
  std::int64_t fixed = 0, adaptive = 0;
  const Series one = run({5.0, strain, 10}, fixed);
  const Series other = run({5.0, strain, 10, 0.0, AdaptiveTimeStep{time_step, 3.0 * time_step, 7}}, adaptive);
  EXPECT_EQ(one.column("shear_strain").values, other.column("shear_strain").values);
  EXPECT_LT(adaptive, fixed);
}

TEST(ShearTestRecord, MeasuresTheSameWhateverRowsAreKept) {
  const auto measured = [](int rows) {
    const auto engine = make_engine("native", "/dev/null");
    DemSample sample(*engine, touching_lattice(), {Material{}, time_step, 0.0});
    return run_shear_test(sample, {5.0, 5.0 * 700 * time_step, rows}).measured;
  };
  const Series few = measured(10), many = measured(470);
  EXPECT_EQ(few.rows(), (ShearTest{5.0, 5.0 * 700 * time_step, 10}.measured_steps(time_step).size()));
  expect_same_bits(few, many);
}

TEST(ShearTestRecord, KeepsItsInertialNumberFiniteWhenNoContactIsLeft) {
  Assembly gas = touching_lattice();
  for (double& radius : gas.radius) radius *= 0.9;
  const auto engine = make_engine(engine_names_of_build().front(), testing::TempDir() + "shear_test.log");
  DemSample sample(*engine, gas, {Material{}, time_step, 0.0});
  const Series series = run_shear_test(sample, {5.0, 5.0 * 40 * time_step, 10}).rows;
  EXPECT_NO_THROW(series.check());
  EXPECT_EQ(series.column("normal_stress").values.back(), 0.0);
  // Velocities of 1 mm/s in 30 % solid: some 1e-4 Pa, and so a number above that of any packing.
  EXPECT_GT(series.column("mean_stress").values.back(), 0.0);
  EXPECT_GT(series.column("inertial_number").values.back(), 10.0);
}

TEST(ForSample, TakesTheRateOfAnInertialNumberFromTheGrains) {
  SampleRecipe recipe;
  recipe.normal_stress = 28e3;
  ShearTest test;
  test.inertial_number = 1e-2;
  EXPECT_EQ(for_sample(test, recipe, 3e-3).shear_rate, shear_rate_for(1e-2, 3e-3, Material{}.density, 28e3));
  ShearTest at_a_rate;
  at_a_rate.shear_rate = 1.0;
  EXPECT_EQ(for_sample(at_a_rate, recipe, 3e-3).shear_rate, 1.0);
}

}  // namespace
}  // namespace flowslide
