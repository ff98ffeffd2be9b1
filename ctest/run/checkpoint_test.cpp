// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "record/same_bits.hpp"
#include "run/example_checkpoint.hpp"

namespace flowslide {
namespace {

Checkpoint read_back(const Checkpoint& checkpoint) {
  auto file = hdf5::File::create("memory");
  write_checkpoint(file.root(), checkpoint);
  return read_checkpoint(hdf5::File::open(file.image(), "memory").root());
}

TEST(Checkpoint, IsReadBackBitForBit) {
  const Checkpoint checkpoint = example_checkpoint();
  const Checkpoint again = read_back(checkpoint);
  expect_same_bits(checkpoint.partial_result.series, again.partial_result.series);
  EXPECT_EQ(again.partial_result.configuration, checkpoint.partial_result.configuration);
  EXPECT_EQ(again.sample.numbers, checkpoint.sample.numbers);
  expect_same_bits(*checkpoint.sample.grains, *again.sample.grains);
  EXPECT_EQ(again.share_done, checkpoint.share_done);
  ASSERT_TRUE(again.slide);
  const SlideState &a = checkpoint.slide->state, &b = again.slide->state;
  EXPECT_EQ(b.exchanges, a.exchanges);
  EXPECT_EQ(b.time, a.time);
  EXPECT_EQ(b.sliding.displacement, a.sliding.displacement);
  EXPECT_EQ(b.sliding.velocity, a.sliding.velocity);
  EXPECT_EQ(b.velocity, a.velocity);
  EXPECT_EQ(b.largest_velocity, a.largest_velocity);
  EXPECT_EQ(b.strain.shear, a.strain.shear);
  EXPECT_EQ(b.strain.compression, a.strain.compression);
  EXPECT_EQ(b.owed.shear, a.owed.shear);
  EXPECT_EQ(b.owed.compression, a.owed.compression);
  EXPECT_EQ(b.driving_stress, a.driving_stress);
  EXPECT_EQ(b.stress.shear, a.stress.shear);
  EXPECT_EQ(b.stress.normal, a.stress.normal);
  EXPECT_EQ(b.global_rate, a.global_rate);
  EXPECT_EQ(b.rate_asked, a.rate_asked);
  EXPECT_EQ(b.rate_applied, a.rate_applied);
  EXPECT_EQ(b.steps, a.steps);
  EXPECT_EQ(b.local_time, a.local_time);
  EXPECT_EQ(b.local_steps, a.local_steps);
  EXPECT_EQ(b.unmeasured_runs, a.unmeasured_runs);
  EXPECT_EQ(b.rest.probed, a.rest.probed);
  EXPECT_EQ(b.rest.rested, a.rest.rested);
  EXPECT_EQ(again.slide->spacing.interval, checkpoint.slide->spacing.interval);
  EXPECT_EQ(again.slide->spacing.strain, checkpoint.slide->spacing.strain);  // infinite
  EXPECT_EQ(again.slide->spacing.most_rows, checkpoint.slide->spacing.most_rows);
  EXPECT_EQ(again.slide->next_time, checkpoint.slide->next_time);
  EXPECT_EQ(again.slide->next_strain, checkpoint.slide->next_strain);
}

TEST(Checkpoint, KeepsWhatMetricsAreMadeOf) {
  const Checkpoint checkpoint = example_checkpoint();
  const Checkpoint again = read_back(checkpoint);
  std::vector<double> numbers, numbers_again;
  for_each_number_of(checkpoint.slide->exchanges,
                     [&](const char*, const auto& value) { numbers.push_back(static_cast<double>(value)); });
  for_each_number_of(again.slide->exchanges,
                     [&](const char*, const auto& value) { numbers_again.push_back(static_cast<double>(value)); });
  EXPECT_EQ(numbers_again, numbers);
  const auto expect_same = [](const WindowRecord& a, const WindowRecord& b) {
    expect_same_bits(a.means, b.means);
    EXPECT_EQ(a.means.rows(), 2U);
    EXPECT_EQ(b.width, a.width);
    EXPECT_EQ(b.number, a.number);
    EXPECT_EQ(b.begin, a.begin);
    EXPECT_EQ(b.at, a.at);
    EXPECT_EQ(b.values, a.values);
    EXPECT_EQ(b.sums, a.sums);
  };
  expect_same(checkpoint.slide->exchanges.over_time, again.slide->exchanges.over_time);
  expect_same(checkpoint.slide->exchanges.over_strain, again.slide->exchanges.over_strain);
  expect_same(checkpoint.slide->exchanges.over_displacement, again.slide->exchanges.over_displacement);
  expect_same_bits(checkpoint.measured, again.measured);
}

TEST(Checkpoint, KeepsProfilesAndShots) {
  const Checkpoint checkpoint = example_checkpoint();
  const Checkpoint again = read_back(checkpoint);
  ASSERT_EQ(again.slide->profiles.size(), checkpoint.slide->profiles.size());
  for (std::size_t i = 0; i < again.slide->profiles.size(); ++i) {
    const ProfileSums &a = checkpoint.slide->profiles[i], &b = again.slide->profiles[i];
    EXPECT_TRUE(b.first == a.first);
    EXPECT_TRUE(b.sum == a.sum);
    EXPECT_EQ(b.snapshots, a.snapshots);
  }
  expect_same_bits(checkpoint.slide->complete_profiles, again.slide->complete_profiles);
  ASSERT_EQ(again.shots.size(), 1U);
  EXPECT_EQ(again.shots[0].strain, checkpoint.shots[0].strain);
  expect_same_bits(checkpoint.shots[0].assembly, again.shots[0].assembly);
}

TEST(Checkpoint, OfAnElementTestHasNoSlide) {
  Checkpoint checkpoint = example_checkpoint();
  checkpoint.slide.reset();
  checkpoint.sample.grains.reset();
  const Checkpoint again = read_back(checkpoint);
  EXPECT_FALSE(again.slide);
  EXPECT_FALSE(again.sample.grains);
}

TEST(Checkpoint, CanBeReadAsAResult) {
  auto file = hdf5::File::create("memory");
  write_checkpoint(file.root(), example_checkpoint());
  expect_same_bits(read_result(file.root()).series, example_checkpoint().partial_result.series);
}

TEST(Checkpoint, RefusesWhatNoRunCouldGoOnFrom) {
  const auto refuse = [](auto&& spoil) {
    Checkpoint checkpoint = example_checkpoint();
    spoil(checkpoint);
    EXPECT_THROW(read_back(checkpoint), CorruptFileError);
  };
  refuse([](Checkpoint& c) { c.sample.grains->position[3].x() = std::nan(""); });
  refuse([](Checkpoint& c) { c.sample.grains->radius[0] = -1.0; });
  refuse([](Checkpoint& c) { c.sample.grains->cell.upper = c.sample.grains->cell.lower; });
  refuse([](Checkpoint& c) { c.sample.numbers["time"] = INFINITY; });
  refuse([](Checkpoint& c) { c.slide->state.velocity = std::nan(""); });
  refuse([](Checkpoint& c) { c.slide->state.local_steps = -1; });
  refuse([](Checkpoint& c) { c.slide->spacing.interval = 0.0; });
  refuse([](Checkpoint& c) { c.slide->profiles[0].snapshots = -2; });
  refuse([](Checkpoint& c) { c.slide->exchanges.peak_to_2.stress = std::nan(""); });
  refuse([](Checkpoint& c) { c.slide->exchanges.over_time.width = 0.0; });
  refuse([](Checkpoint& c) { c.slide->exchanges.over_strain.sums.pop_back(); });
  refuse([](Checkpoint& c) { c.slide->exchanges.over_strain.values[0] = INFINITY; });
  refuse([](Checkpoint& c) { c.slide->exchanges.over_displacement.at = -1.0; });
}

}  // namespace
}  // namespace flowslide
