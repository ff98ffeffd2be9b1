// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/profile_record.hpp"

#include <algorithm>

#include "dem/make_engine.hpp"
#include "grains/packing.hpp"
#include "sample/failure.hpp"
#include "sample/glued_layers.hpp"
#include "support/messages.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

Series profile(const std::vector<double>& values) {
  Series series;
  series.axis.values = {0.1, 0.3, 0.5, 0.7, 0.9};
  series.columns = {{"velocity_1", "v", "1", "velocity", "", values}};
  return series;
}

TEST(ProfileRecord, MeasuresHowStraightAProfileIs) {
  EXPECT_NEAR(linearity(profile({1.0, 3.0, 5.0, 7.0, 9.0}), "velocity_1"), 1.0, 1e-14);
  // Sums of squares about the means: 0.4, 0.8 and xy = 0.4 give 0.16 / 0.32.
  EXPECT_NEAR(linearity(profile({0.0, 0.0, 0.0, 0.0, 1.0}), "velocity_1"), 0.5, 1e-14);
}

/// Grains between glued layers, moving as simple shear does.
class ProfileRecordOfGrains : public testing::Test {
 protected:
  ProfileRecordOfGrains() : engine_(make_engine("native", "/dev/null")) {
    sample_ = std::make_unique<DemSample>(*engine_, touching_lattice(5, 6), EngineSettings{Material{}, 1e-6, 0.0});
    sample_->start_linear_velocity_field(2.0);
    sample_->strain({{2.0, 0.0}, 1, 1e-6});
  }
  std::unique_ptr<Engine> engine_;
  std::unique_ptr<DemSample> sample_;
};

TEST_F(ProfileRecordOfGrains, TakesSnapshotsWhenTheyAreDue) {
  ProfileRecord record({3, 2, 1.0, {0.1, 0.5}});  // at 0.1, 0.15, 0.5 and 0.75
  for (const double strain : {0.0, 0.05, 0.1, 0.12, 0.2, 0.3, 0.45, 0.5, 0.7}) record.take(strain, *sample_);
  Series series = record.series();
  ASSERT_EQ(series.columns.size(), 6U);  // the second profile waits for its last snapshot
  record.take(0.8, *sample_);
  series = record.series();
  ASSERT_EQ(series.columns.size(), 12U);
  EXPECT_EQ(series.axis.values, (std::vector{0.5 / 3.0, 1.5 / 3.0, 2.5 / 3.0}));
  EXPECT_EQ(series.columns[3].name, "snapshot_velocity_1");
  EXPECT_EQ(series.columns[6].name, "velocity_2");
}

TEST_F(ProfileRecordOfGrains, HasTheFirstSnapshotBesideTheMean) {
  ProfileRecord mean({3, 2, 1.0, {0.1}}), first({3, 1, 0.0, {0.1}}), second({3, 1, 0.0, {0.16}});
  mean.take(0.1, *sample_);
  first.take(0.1, *sample_);
  sample_->strain({{3.0, 0.0}, 200, 1e-6});  // the field is another at the second snapshot
  mean.take(0.16, *sample_);
  second.take(0.16, *sample_);
  const Series both = mean.series();
  for (const char* column : {"velocity_1", "shear_stress_1", "normal_stress_1"})
    EXPECT_EQ(both.column(std::string("snapshot_") + column).values, first.series().column(column).values);
  const ProfileValues &sum = mean.sums()[0].sum, &a = first.sums()[0].sum, &b = second.sums()[0].sum;
  ASSERT_NE(a.velocity, b.velocity);
  for (std::size_t layer = 0; layer < 3; ++layer)
    EXPECT_EQ(both.column("velocity_1").values[layer],
              (a.velocity[layer] + b.velocity[layer]) / (a.top_velocity + b.top_velocity));
  EXPECT_EQ(sum.normal[1], a.normal[1] + b.normal[1]);
  EXPECT_FALSE(first.series().has("snapshot_velocity_1"));

  ProfileRecord snapshot({3, 2, 1.0, {0.1}, ProfileReading::first_snapshot});
  snapshot.restore(mean.sums());
  EXPECT_EQ(snapshot.series().column("velocity_1").values, both.column("snapshot_velocity_1").values);
  EXPECT_EQ(snapshot.series().column("mean_velocity_1").values, both.column("velocity_1").values);
}

TEST_F(ProfileRecordOfGrains, HasTheFirstSnapshotOfARunThatEndsBeforeTheLast) {
  ProfileRecord mean({3, 2, 1.0, {0.1}}), first({3, 2, 1.0, {0.1}, ProfileReading::first_snapshot});
  mean.take(0.1, *sample_);
  first.take(0.1, *sample_);
  EXPECT_TRUE(mean.series().columns.empty());
  EXPECT_EQ(first.series().columns.size(), 3U);
  EXPECT_TRUE(first.series().has("velocity_1"));
}

TEST_F(ProfileRecordOfGrains, GoesOnFromWhatItHad) {
  const ProfilePlan plan{3, 2, 1.0, {0.1, 0.5}};
  const std::vector<std::vector<double>> stops{{}, {0.12}, {0.12, 0.2}, {0.12, 0.2, 0.6}};
  for (const std::vector<double>& before : stops) {
    ProfileRecord whole(plan), first(plan), second(plan);
    for (const double strain : before) first.take(strain, *sample_);
    second.restore(first.sums());
    for (const double strain : {0.12, 0.2, 0.6, 0.8}) {
      whole.take(strain, *sample_);
      if (std::find(before.begin(), before.end(), strain) == before.end()) second.take(strain, *sample_);
    }
    EXPECT_EQ(second.series().columns.size(), 12U);
    ASSERT_EQ(second.sums().size(), whole.sums().size());
    for (std::size_t i = 0; i < whole.sums().size(); ++i) {
      EXPECT_TRUE(second.sums()[i].first == whole.sums()[i].first) << before.size();
      EXPECT_TRUE(second.sums()[i].sum == whole.sums()[i].sum) << before.size();
      EXPECT_EQ(second.sums()[i].snapshots, whole.sums()[i].snapshots);
    }
  }
}

TEST_F(ProfileRecordOfGrains, RefusesSumsOfAnotherPlan) {
  ProfileRecord record({3, 2, 1.0, {0.1, 0.5}});
  record.take(0.12, *sample_);
  const std::vector<ProfileSums> sums = record.sums();
  EXPECT_THROW(ProfileRecord({4, 2, 1.0, {0.1}}).restore(sums), std::invalid_argument);
  EXPECT_THROW(ProfileRecord({3, 2, 1.0, {}}).restore(sums), std::invalid_argument);
  EXPECT_THROW(ProfileRecord({3, 2, 1.0, {0.1, 0.5}}).restore({sums[0], sums[0]}), std::invalid_argument);
}

TEST_F(ProfileRecordOfGrains, GivesVelocityAsAShareOfTheTop) {
  ProfileRecord record({3, 1, 0.0, {0.0}});
  record.take(0.0, *sample_);
  const Series series = record.series();
  const std::vector<double>& velocity = series.column("velocity_1").values;
  const double half_a_grain = 0.5 / 6.0;  // of the height: what a sublayer holds is not spread evenly over it
  for (std::size_t layer = 0; layer < 3; ++layer)
    EXPECT_NEAR(velocity[layer], series.axis.values[layer], half_a_grain);
  EXPECT_GT(linearity(series, "velocity_1"), 0.99);
}

/// Loose grains between glued layers.
Assembly gas() {
  LatticePacking recipe;
  recipe.counts = {5, 5, 6};
  Assembly assembly = lattice_packing(recipe);
  assembly.cell.periodic = {true, true, false};
  glue_layers(assembly, Glue::one_layer);
  return assembly;
}

TEST(ProfileRecord, LeavesOutProfilesOfASampleThatBearsNothing) {
  const auto engine = make_engine("native", "/dev/null");
  DemSample sample(*engine, gas(), EngineSettings{Material{}, 1e-6, 0.0});
  ProfileRecord record({3, 1, 0.0, {0.0, 0.1}});
  record.take(0.0, sample);
  record.take(0.1, sample);
  EXPECT_EQ(record.sums().size(), 2U);
  EXPECT_TRUE(record.series().columns.empty());  // relative to a stress of 0, values would be NaN
}

TEST(ProfileRecord, FailsWithASublayerThatHoldsNoSolid) {
  const auto engine = make_engine("native", "/dev/null");
  DemSample sample(*engine, gas(), EngineSettings{Material{}, 1e-6, 0.0});
  ProfileRecord record({200, 1, 0.0, {0.5}});
  EXPECT_CONTAINS(message_of<NumericalFailure>([&] { record.take(0.5, sample); }),
                  "profiles at a shear strain of 0.5: solid volume of a sublayer is 0; allowed: > 0 m^3. Use fewer");
}

}  // namespace
}  // namespace flowslide
