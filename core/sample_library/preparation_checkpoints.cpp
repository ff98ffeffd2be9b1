// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/preparation_checkpoints.hpp"

#include <fmt/format.h>

#include <iostream>
#include <utility>

#include "process/mpi_session.hpp"
#include "process/ranks.hpp"
#include "record/assembly_group.hpp"
#include "record/read_finite.hpp"

namespace flowslide {
namespace {

constexpr const char* part = "preparation";

/// Calls `visit(name, member)` for each number of a state. Writing and reading share this list.
template <typename State, typename Visit>
void for_each_number(State& state, Visit&& visit) {
  visit("steps", state.steps);
  visit("stage_start", state.stage_start);
  visit("within", state.within);
  visit("next_inspection", state.next_inspection);
  visit("normal_stress", state.stress.normal);
  visit("shear_stress", state.stress.shear);
  visit("transverse_stress", state.stress.transverse);
  visit("lateral_stress_x", state.stress.lateral_x);
  visit("lateral_stress_y", state.stress.lateral_y);
}

void write(hdf5::Group& root, const std::string& key, const PreparationState& state) {
  auto group = root.create_group(part);
  group.set_attribute("key", key);
  group.set_attribute("stage", state.stage);
  for_each_number(state, [&](const char* name, auto value) { group.set_attribute(name, value); });
  write_assembly(group, "grains", state.assembly);
}

PreparationState read(const hdf5::Group& root, const std::string& key) {
  const auto group = root.group(part);
  if (group.text_attribute("key") != key) throw CorruptFileError(group.label() + " is of another sample");
  PreparationState state;
  const std::int64_t stage = group.integer_attribute("stage");
  if (stage < 0 || stage > 5) throw CorruptFileError(fmt::format("{}: stage {}", group.label(), stage));
  state.stage = static_cast<int>(stage);
  for_each_number(state, ReadNumber{group});
  state.assembly = read_finite_assembly(group, "grains");
  return state;
}

void say(const std::string& text) {
  if (mpi_rank() == 0) std::cerr << "flowslide: " << text << std::endl;
}

}  // namespace

PreparationCheckpoints::PreparationCheckpoints(const std::filesystem::path& folder, std::string key)
    : store_(folder, key), key_(std::move(key)) {}

std::optional<PreparationState> PreparationCheckpoints::find() const {
  std::optional<PreparationState> found;
  try {
    store_.read_newest([&](const hdf5::Group& root) { found = read(root, key_); },
                       [](std::string_view word) { say(fmt::format("{}; trying the checkpoint before it", word)); });
  } catch (const CorruptFileError& error) {
    found.reset();
    say(fmt::format("{}; the preparation starts again", error.what()));
  }
  return found;
}

bool PreparationCheckpoints::keep(const PreparationState& state) {
  bool kept = true;
  if (mpi_rank() == 0) {
    try {
      store_.put([&](hdf5::Group& root) { write(root, key_, state); });
    } catch (const FileError& error) {
      kept = false;
      say(error.what());
    }
  }
  return same_on_all_ranks(kept);
}

void PreparationCheckpoints::remove() const {
  if (mpi_rank() == 0) store_.remove();
}

}  // namespace flowslide
