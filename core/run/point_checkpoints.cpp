// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/point_checkpoints.hpp"

#include <fmt/format.h>

#include <iostream>
#include <stdexcept>
#include <utility>

#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"
#include "process/ranks.hpp"

namespace flowslide {
namespace {

void say(const std::string& text) {
  if (mpi_rank() == 0) std::cerr << text << std::endl;
}

}  // namespace

PointCheckpoints::PointCheckpoints(CheckpointStore store, RunControl& control, const RunIdentity& identity)
    : store_(std::move(store)), control_(control) {
  // cppcheck-suppress useInitializationList
  const auto read = [&](const hdf5::Group& root) { found_ = read_checkpoint(root); };
  const auto complain = [](std::string_view word) {
    say(fmt::format("flowslide: {}; trying the checkpoint before it", word));
  };
  try {
    if (store_.read_newest(read, complain) == 0) return;
  } catch (const CorruptFileError& error) {
    throw CorruptFileError(
        fmt::format("{}; begin this run anew with --afresh, or choose another folder with --output", error.what()));
  }
  const std::string difference = identity.difference_from(RunIdentity(found_->partial_result));
  if (!difference.empty())
    throw Refused(
        fmt::format("the checkpoint {} is of another run ({}); {}", store_.path(0).string(), difference, begin_anew));
  say(fmt::format("{}: continues from its checkpoint at {}", label(), place_of(*found_)));
}

std::string PointCheckpoints::label() const {
  return found_ ? found_->partial_result.provenance.case_name + " " + found_->partial_result.provenance.point
                : std::string("it");
}

void PointCheckpoints::poll(const std::function<Checkpoint()>& now) {
  const RunControl::Due due = control_.poll();
  if (due == RunControl::Due::nothing) return;
  const Checkpoint checkpoint = now();
  keep(checkpoint, due == RunControl::Due::stop);
  control_.kept();
  if (due == RunControl::Due::stop)
    control_.stop(fmt::format("the same command continues from {}", place_of(checkpoint)));
}

void PointCheckpoints::keep(const Checkpoint& checkpoint, bool stopping) {
  std::string failure;
  if (mpi_rank() == 0) {
    try {
      store_.put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
    } catch (const FileError& error) {
      failure = error.what();
    }
  }
  if (same_on_all_ranks(failure.empty())) return;
  failure += store_.empty() ? "; there is no checkpoint" : "; the checkpoint before is as it was";
  if (stopping) on_first_rank([&] { throw FileError(failure); });
  say("flowslide: " + failure);
}

std::string place_of(const Checkpoint& checkpoint) {
  if (checkpoint.slide) {
    const SlideState& state = checkpoint.slide->state;
    return fmt::format("t = {:.4g} s, v = {:.3g} m/s, sigma = {:.4g} Pa", state.time, state.velocity,
                       state.stress.normal);
  }
  const Series& rows = checkpoint.partial_result.series;
  if (rows.rows() == 0) return "its start";
  return fmt::format("t = {:.4g} s, gamma = {:.3g} %, sigma = {:.4g} Pa", rows.axis.values.back(),
                     100.0 * rows.column("shear_strain").values.back(), rows.column("normal_stress").values.back());
}

}  // namespace flowslide
