// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/instance.hpp"

#include <input.h>
#include <lammps.h>
#include <mpi.h>
#include <universe.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "dem/engine.hpp"
#include "dem/liggghts/c_locale.hpp"
#include "dem/liggghts/error_bridge.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

using Instances = std::vector<std::unique_ptr<LAMMPS_NS::LAMMPS>>;

int delete_instances(MPI_Comm, int, void* instances, void*) {
  static_cast<Instances*>(instances)->clear();
  return MPI_SUCCESS;
}

/// Unused instances, which are cleared and used again by the same ranks. MPI_Finalize, which may come before the end of
/// the program, deletes them: it first deletes the attributes of MPI_COMM_SELF.
Instances& idle() {
  static Instances* const instances = [] {
    auto* empty = new Instances;
    int key = MPI_KEYVAL_INVALID;
    MPI_Comm_create_keyval(MPI_COMM_NULL_COPY_FN, delete_instances, &key, nullptr);
    MPI_Comm_set_attr(MPI_COMM_SELF, key, empty);
    return empty;
  }();
  return *instances;
}

/// An unused instance of the ranks of `communicator`, in the same order, or nullptr. Every rank takes the same: the
/// instances of these ranks became unused in the same order on each of them.
LAMMPS_NS::LAMMPS* take_idle(MPI_Comm communicator) {
  for (auto instance = idle().rbegin(); instance != idle().rend(); ++instance) {
    int relation = MPI_UNEQUAL;
    MPI_Comm_compare((*instance)->world, communicator, &relation);
    if (relation != MPI_IDENT && relation != MPI_CONGRUENT) continue;
    LAMMPS_NS::LAMMPS* const taken = instance->release();
    idle().erase(std::next(instance).base());
    return taken;
  }
  return nullptr;
}

LAMMPS_NS::LAMMPS* start(MPI_Comm communicator) {
  MPI_Comm own = MPI_COMM_NULL;
  MPI_Comm_dup(communicator, &own);
  std::array<std::string, 5> words{"flowslide", "-log", "none", "-screen", "none"};
  std::array<char*, 5> arguments;
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  // Each instance after the first registers the contact models again and prints hundreds of warnings about it.
  const auto state = std::cerr.rdstate();
  std::cerr.setstate(std::ios::failbit);
  auto* instance = new LAMMPS_NS::LAMMPS(static_cast<int>(arguments.size()), arguments.data(), own);
  std::cerr.clear(state);
  return instance;
}

}  // namespace

LiggghtsInstance::LiggghtsInstance(std::filesystem::path log, MPI_Comm communicator) : log_(std::move(log)) {
  ensure_mpi();
  const CLocale decimal_point;
  instance_ = take_idle(communicator);
  if (instance_) {
    command("clear");
  } else {
    enter("starting");
    instance_ = start(communicator);
  }
  open_log();
}

LiggghtsInstance::~LiggghtsInstance() {
  // After an error LIGGGHTS expects the process to end. Its objects can then be neither cleared nor deleted.
  if (!liggghts_activity().broken.contains(instance_)) idle().emplace_back(instance_);
}

MPI_Comm LiggghtsInstance::communicator() const { return instance_->world; }

void LiggghtsInstance::enter(std::string activity) const {
  liggghts_activity().doing = std::move(activity);
  liggghts_activity().log = log_;
}

/// Does the same as the command `log` of LIGGGHTS, whose parser does not accept quotes, "$" or "&" in a path.
void LiggghtsInstance::open_log() {
  int reason = 0;
  int rank = 0;
  MPI_Comm_rank(communicator(), &rank);
  if (rank == 0) {
    if (instance_->logfile) std::fclose(instance_->logfile);
    instance_->logfile = std::fopen(log_.c_str(), "w");
    if (!instance_->logfile) reason = errno;
    instance_->universe->ulogfile = instance_->logfile;
  }
  MPI_Bcast(&reason, 1, MPI_INT, 0, communicator());
  if (reason == 0) return;
  idle().emplace_back(instance_);
  throw std::system_error(reason, std::generic_category(), "LIGGGHTS cannot write its log " + log_.string());
}

void LiggghtsInstance::command(const std::string& line) {
  const CLocale decimal_point;
  enter("command '" + line + "'");
  instance_->input->one(line.c_str());
}

}  // namespace flowslide
