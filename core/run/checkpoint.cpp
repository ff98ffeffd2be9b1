// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/checkpoint.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "record/assembly_group.hpp"
#include "record/read_finite.hpp"
#include "record/series_group.hpp"

namespace flowslide {
namespace {

constexpr const char *part = "checkpoint", *complete_profiles = "complete_profiles", *measured = "measured";

/// Calls `visit(name, member)` for each number of a state. Writing and reading share this list.
template <typename State, typename Visit>
void for_each_number(State& state, Visit&& visit) {
  visit("exchanges", state.exchanges);
  visit("time", state.time);
  visit("displacement", state.sliding.displacement);
  visit("half_step_velocity", state.sliding.velocity);
  visit("velocity", state.velocity);
  visit("largest_velocity", state.largest_velocity);
  visit("shear_strain", state.strain.shear);
  visit("compression", state.strain.compression);
  visit("owed_shear_strain", state.owed.shear);
  visit("owed_compression", state.owed.compression);
  visit("driving_stress", state.driving_stress);
  visit("shear_stress", state.stress.shear);
  visit("normal_stress", state.stress.normal);
  visit("global_rate", state.global_rate);
  visit("rate_asked", state.rate_asked);
  visit("rate_applied", state.rate_applied);
  visit("steps", state.steps);
  visit("local_time", state.local_time);
  visit("local_steps", state.local_steps);
  visit("unmeasured_runs", state.unmeasured_runs);
  visit("probed_strain", state.rest.probed);
  visit("rested_strain", state.rest.rested);
  visit("adaptive_time_step", state.adaptive.time_step);
  visit("steps_of_adaptive_time_step", state.adaptive.steps);
}

struct WriteNumber {
  hdf5::Group& group;
  void operator()(const char* name, double value) const { group.set_attribute(name, value); }
  void operator()(const char* name, std::int64_t value) const { group.set_attribute(name, value); }
};

void write_values(hdf5::Group& group, const ProfileValues& values) {
  group.write<double>("velocity", values.velocity, {values.velocity.size()});
  group.write<double>("shear_stress", values.shear, {values.shear.size()});
  group.write<double>("normal_stress", values.normal, {values.normal.size()});
  group.set_attribute("top_velocity", values.top_velocity);
  group.set_attribute("sample_shear_stress", values.sample_shear);
  group.set_attribute("sample_normal_stress", values.sample_normal);
}

ProfileValues read_values(const hdf5::Group& group) {
  ProfileValues values;
  values.velocity = group.read<double>("velocity", {hdf5::Group::any});
  values.shear = group.read<double>("shear_stress", {values.velocity.size()});
  values.normal = group.read<double>("normal_stress", {values.velocity.size()});
  values.top_velocity = group.number_attribute("top_velocity");
  values.sample_shear = group.number_attribute("sample_shear_stress");
  values.sample_normal = group.number_attribute("sample_normal_stress");
  return values;
}

void write_profiles(hdf5::Group& parent, const std::vector<ProfileSums>& profiles) {
  auto group = parent.create_group("profiles");
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    auto one = group.create_group(fmt::format("{}", i));
    auto first = one.create_group("first"), sum = one.create_group("sum");
    write_values(first, profiles[i].first);
    write_values(sum, profiles[i].sum);
    one.set_attribute("snapshots", profiles[i].snapshots);
  }
}

std::vector<ProfileSums> read_profiles(const hdf5::Group& parent) {
  const auto group = parent.group("profiles");
  std::vector<ProfileSums> profiles;
  for (std::size_t i = 0; i < group.names().size(); ++i) {
    const auto one = group.group(fmt::format("{}", i));
    const std::int64_t snapshots = one.integer_attribute("snapshots");
    if (snapshots < 0 || snapshots > std::numeric_limits<int>::max())
      throw CorruptFileError(fmt::format("{}: {} snapshots", one.label(), snapshots));
    profiles.push_back({read_values(one.group("first")), read_values(one.group("sum")), static_cast<int>(snapshots)});
  }
  return profiles;
}

/// Calls `visit(name, windows)` for each kind of windows of a record.
template <typename Record, typename Visit>
void for_each_window(Record& record, Visit&& visit) {
  visit("over_time", record.over_time);
  visit("over_strain", record.over_strain);
  visit("over_displacement", record.over_displacement);
}

void write_exchanges(hdf5::Group& parent, const ExchangeRecord& record) {
  auto group = parent.create_group("exchanges");
  for_each_number_of(record, WriteNumber{group});
  for_each_window(record, [&](const char* name, const WindowRecord& windows) {
    auto one = group.create_group(name);
    write_series(one, "means", windows.means);
    one.set_attribute("width", windows.width);
    one.set_attribute("number", windows.number);
    one.set_attribute("begin", windows.begin);
    one.set_attribute("at", windows.at);
    one.write<double>("values", windows.values, {windows.values.size()});
    one.write<double>("sums", windows.sums, {windows.sums.size()});
  });
}

std::vector<double> read_finite(const hdf5::Group& group, const char* name, std::size_t size) {
  std::vector<double> values = group.read<double>(name, {size});
  for (const double value : values)
    if (!std::isfinite(value)) throw CorruptFileError(fmt::format("{}: {} is not finite", group.label(), name));
  return values;
}

ExchangeRecord read_exchanges(const hdf5::Group& parent) {
  const auto group = parent.group("exchanges");
  ExchangeRecord record;
  for_each_number_of(record, ReadNumber{group});
  for_each_window(record, [&](const char* name, WindowRecord& windows) {
    const auto one = group.group(name);
    const ReadNumber read{one};
    windows.means = read_series(one, "means");
    read("width", windows.width);
    read("number", windows.number);
    read("begin", windows.begin);
    read("at", windows.at);
    const std::size_t size = windows.number > 0 ? windows.means.columns.size() : 0;
    windows.values = read_finite(one, "values", size);
    windows.sums = read_finite(one, "sums", size);
    if (!(windows.width > 0.0 && windows.at >= windows.begin))
      throw CorruptFileError(one.label() + ": windows that are not in order");
  });
  return record;
}

void write_slide(hdf5::Group& parent, const SlideCheckpoint& slide) {
  auto group = parent.create_group("slide");
  for_each_number(slide.state, WriteNumber{group});
  group.set_attribute("row_interval", slide.spacing.interval);
  group.set_attribute("row_strain", slide.spacing.strain);
  group.set_attribute("most_rows", slide.spacing.most_rows);
  group.set_attribute("next_row_time", slide.next_time);
  group.set_attribute("next_row_strain", slide.next_strain);
  write_profiles(group, slide.profiles);
  write_exchanges(group, slide.exchanges);
  if (!slide.complete_profiles.columns.empty()) write_series(group, complete_profiles, slide.complete_profiles);
}

SlideCheckpoint read_slide(const hdf5::Group& parent) {
  const auto group = parent.group("slide");
  SlideCheckpoint slide;
  for_each_number(slide.state, ReadNumber{group});
  slide.spacing = {group.number_attribute("row_interval"), group.number_attribute("row_strain"),
                   group.integer_attribute("most_rows")};
  if (!(slide.spacing.interval > 0.0 && slide.spacing.strain > 0.0 && slide.spacing.most_rows > 1))
    throw CorruptFileError(group.label() + ": distances between rows that are not positive");
  slide.next_time = group.number_attribute("next_row_time");
  slide.next_strain = group.number_attribute("next_row_strain");
  slide.profiles = read_profiles(group);
  slide.exchanges = read_exchanges(group);
  if (group.has(complete_profiles)) slide.complete_profiles = read_series(group, complete_profiles);
  return slide;
}

void write_sample(hdf5::Group& parent, const SampleState& sample) {
  auto group = parent.create_group("sample");
  auto numbers = group.create_group("numbers");
  for (const auto& [name, value] : sample.numbers) numbers.write(name, value);
  if (sample.grains) write_assembly(group, "grains", *sample.grains);
}

SampleState read_sample(const hdf5::Group& parent) {
  const auto group = parent.group("sample");
  const auto numbers = group.group("numbers");
  SampleState sample;
  for (const std::string& name : numbers.names()) {
    const double value = numbers.read_number(name);
    if (!std::isfinite(value)) throw CorruptFileError(fmt::format("{}: {} is {}", numbers.label(), name, value));
    sample.numbers[name] = value;
  }
  if (group.has("grains")) sample.grains = read_finite_assembly(group, "grains");
  return sample;
}

}  // namespace

void write_checkpoint(hdf5::Group& root, const Checkpoint& checkpoint) {
  write_result(root, checkpoint.partial_result);
  auto group = root.create_group(part);
  group.set_attribute("share_done", checkpoint.share_done);
  write_sample(group, checkpoint.sample);
  if (checkpoint.slide) write_slide(group, *checkpoint.slide);
  if (!checkpoint.measured.columns.empty()) write_series(group, measured, checkpoint.measured);
  auto shots = group.create_group("shots");
  for (std::size_t i = 0; i < checkpoint.shots.size(); ++i) {
    auto shot = shots.create_group(fmt::format("{}", i));
    shot.set_attribute("time", checkpoint.shots[i].time);
    shot.set_attribute("strain", checkpoint.shots[i].strain);
    write_assembly(shot, "grains", checkpoint.shots[i].assembly);
  }
}

Checkpoint read_checkpoint(const hdf5::Group& root) {
  Checkpoint checkpoint;
  checkpoint.partial_result = read_result(root);
  const auto group = root.group(part);
  checkpoint.share_done = group.number_attribute("share_done");
  checkpoint.sample = read_sample(group);
  if (group.has("slide")) checkpoint.slide = read_slide(group);
  if (group.has(measured)) checkpoint.measured = read_series(group, measured);
  const auto shots = group.group("shots");
  for (std::size_t i = 0; i < shots.names().size(); ++i) {
    const auto shot = shots.group(fmt::format("{}", i));
    checkpoint.shots.push_back(
        {shot.number_attribute("time"), shot.number_attribute("strain"), read_finite_assembly(shot, "grains")});
  }
  return checkpoint;
}

}  // namespace flowslide
