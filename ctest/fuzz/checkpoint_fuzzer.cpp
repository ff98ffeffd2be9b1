// SPDX-License-Identifier: GPL-2.0-or-later
// Checkpoints that are not what a run wrote. By the first byte, either any bytes as a file, which its checksum must
// catch, or a file with a right checksum whose parts are left out, of another shape or of any value, which the reader
// must catch: a CorruptFileError, or a checkpoint from which a run can continue.
#include <unistd.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

#include "record/checkpoint_store.hpp"
#include "require.hpp"
#include "run/checkpoint.hpp"

namespace {

using namespace flowslide;

/// Takes numbers from the input, and zeros when it is used up.
class Input {
 public:
  Input(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  std::uint8_t byte() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }
  template <typename Number>
  Number number() {
    Number value{};
    std::uint8_t bytes[sizeof value];
    for (std::uint8_t& b : bytes) b = byte();
    std::memcpy(&value, bytes, sizeof value);
    return value;
  }
  /// Mostly a plain one, so that the input gets behind the first check.
  double value() { return byte() % 8 == 0 ? number<double>() : 0.01 * (1 + byte()); }
  Vector3 vector() { return {value(), value(), value()}; }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

Assembly assembly_of(Input& input) {
  Assembly assembly;
  assembly.resize(input.byte() % 6);
  assembly.cell = {input.vector(), input.vector(), {true, false, input.byte() % 2 == 0}};
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    assembly.radius[i] = input.value();
    assembly.position[i] = input.vector();
    assembly.force[i] = input.vector();
    assembly.role[i] = static_cast<Role>(input.byte() % 4);
  }
  for (int i = input.byte() % 4; i > 0; --i)
    assembly.contacts.push_back({input.byte() % 6U, input.byte() % 6U, input.vector(), input.vector()});
  return assembly;
}

ProfileValues profile_values_of(Input& input) {
  const auto values = [&] { return std::vector<double>(input.byte() % 3); };
  return {values(), values(), values(), 0, 0, 0};
}

Checkpoint checkpoint_of(Input& input) {
  Checkpoint checkpoint;
  checkpoint.partial_result.series.columns = {{"shear_strain", "gamma", "1", "shear strain", "", {}}};
  for (int i = input.byte() % 4; i > 0; --i)
    checkpoint.partial_result.series.append_row(0.5 * i, std::vector{0.25 * i});
  checkpoint.share_done = input.value();
  for (const char* name : {"time", "steps"}) checkpoint.sample.numbers[name] = input.value();
  if (input.byte() % 2 == 0) checkpoint.sample.grains = assembly_of(input);
  if (input.byte() % 2 == 0) {
    SlideCheckpoint slide;
    slide.state.velocity = input.value();
    slide.state.local_steps = input.byte() % 4 == 0 ? input.number<std::int64_t>() : 5;
    slide.spacing = {input.value(), input.value(), input.byte()};
    for (int i = input.byte() % 3; i > 0; --i)
      slide.profiles.push_back({profile_values_of(input), profile_values_of(input), input.number<std::int8_t>()});
    for (int i = input.byte() % 4; i > 0; --i)
      slide.exchanges.over_strain.add(1e-3 * input.byte(), std::vector<double>(5, input.value()));
    slide.exchanges.largest_strain = input.value();
    checkpoint.slide = slide;
  }
  if (input.byte() % 2 == 0) checkpoint.measured = checkpoint.partial_result.series;
  if (input.byte() % 4 == 0) checkpoint.shots.push_back({input.value(), input.value(), assembly_of(input)});
  return checkpoint;
}

/// Leaves parts out, or puts others in their place.
void spoil(hdf5::Group& root, Input& input) {
  static const char* const groups[] = {"checkpoint",
                                       "checkpoint/sample",
                                       "checkpoint/sample/numbers",
                                       "checkpoint/sample/grains",
                                       "checkpoint/slide",
                                       "checkpoint/slide/profiles",
                                       "checkpoint/slide/exchanges",
                                       "checkpoint/slide/exchanges/over_strain",
                                       "checkpoint/shots",
                                       "checkpoint/measured",
                                       "series",
                                       "metrics",
                                       "parameters",
                                       "windows"};
  for (int i = input.byte() % 4; i > 0; --i) {
    try {
      auto group = root.group(groups[input.byte() % std::size(groups)]);
      const auto names = group.names();
      if (names.empty()) continue;
      const std::string name = names[input.byte() % names.size()];
      H5Ldelete(group.id(), name.c_str(), H5P_DEFAULT);
      const std::vector<double> values(input.byte() % 8, input.value());
      const std::vector<std::uint8_t> bytes(input.byte() % 8, input.byte());
      switch (input.byte() % 5) {
        case 0: break;
        case 1: group.write<double>(name, values, {values.size()}); break;
        case 2: group.write<double>(name, values, {values.size(), 1}); break;
        case 3: group.write<std::uint8_t>(name, bytes, {bytes.size()}); break;
        case 4: group.create_group(name); break;
      }
    } catch (const FileError&) {
    }
  }
}

/// The properties of a checkpoint on which a run relies.
void check(const Checkpoint& checkpoint) {
  const auto grains = [](const Assembly& assembly) {
    require(assembly.position.size() == assembly.size() && assembly.torque.size() == assembly.size());
    for (const Vector3& position : assembly.position) require(position.allFinite());
    for (const double radius : assembly.radius) require(radius > 0.0 && std::isfinite(radius));
    for (const ContactHistory& contact : assembly.contacts)
      require(contact.first < contact.second && contact.second < assembly.size());
    for (const Role role : assembly.role) require(role <= Role::top_layer);
  };
  if (checkpoint.sample.grains) grains(*checkpoint.sample.grains);
  for (const Shot& shot : checkpoint.shots) grains(shot.assembly);
  if (!checkpoint.slide) return;
  require(std::isfinite(checkpoint.slide->state.velocity) && checkpoint.slide->state.local_steps >= 0);
  for (const ProfileSums& sums : checkpoint.slide->profiles)
    for (const ProfileValues& values : {sums.first, sums.sum}) require(values.shear.size() == values.velocity.size());
  const ExchangeRecord& exchanges = checkpoint.slide->exchanges;
  for (const WindowRecord* windows : {&exchanges.over_time, &exchanges.over_strain, &exchanges.over_displacement}) {
    require(windows->width > 0.0 && windows->at >= windows->begin && windows->sums.size() == windows->values.size());
    require(windows->number == 0 || windows->values.size() == windows->means.columns.size());
  }
}

void read(const CheckpointStore& store) {
  try {
    store.read_newest([](const hdf5::Group& root) { check(read_checkpoint(root)); }, [](std::string_view) {});
  } catch (const FileError&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("flowslide_fuzz_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  CheckpointStore store(folder, "fuzz");
  Input input(data, size);
  if (input.byte() % 4 == 0) {
    store.remove();
    std::ofstream(store.path(0), std::ios::binary)
        .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
    read(store);
    return 0;
  }
  try {
    auto file = hdf5::File::create("fuzz");
    write_checkpoint(file.root(), checkpoint_of(input));
    spoil(file.root(), input);
    const auto again = hdf5::File::open(file.image(), "fuzz");  // in memory, because the disk would dominate the time
    check(read_checkpoint(again.root()));
  } catch (const FileError&) {
  } catch (const std::invalid_argument&) {  // of the writer: it must not write such a thing
  }
  return 0;
}
