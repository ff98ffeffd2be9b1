// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/instance.hpp"

#include <fmt/format.h>
#include <input.h>
#include <lammps.h>
#include <mpi.h>
#include <universe.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dem/engine.hpp"
#include "dem/liggghts/c_locale.hpp"
#include "dem/liggghts/error_bridge.hpp"

namespace flowslide {
namespace {

class MpiSession {
 public:
  MpiSession() {
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (initialized) return;
    // A program without mpirun starts Open MPI's daemon, which looks for ssh in PATH and gives up where there is none,
    // although it will never start anything on another machine.
    ::setenv("OMPI_MCA_plm", "isolated", 0);
    MPI_Init(nullptr, nullptr);
    MPI_Comm_dup(MPI_COMM_WORLD, &at_end_);
  }
  ~MpiSession() {
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (at_end_ == MPI_COMM_NULL || finalized) return;
    MPI_Comm_free(&at_end_);
    MPI_Finalize();
  }
  MPI_Comm at_end() const { return at_end_; }

 private:
  MPI_Comm at_end_ = MPI_COMM_NULL;  ///< null unless MPI was started here
};

const MpiSession& session() {
  static const MpiSession the_session;
  return the_session;
}

/// Whether other processes may belong to this one: a launcher such as mpirun has started it, or its host has started MPI.
/// A process alone starts MPI, which takes a third of a second, only when LIGGGHTS needs it.
bool may_have_ranks() {
  static const bool launched = std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
  int initialized = 0;
  MPI_Initialized(&initialized);
  return launched || initialized;
}

/// Instances that no engine uses, kept to be cleared and used again.
std::vector<std::unique_ptr<LAMMPS_NS::LAMMPS>>& idle() {
  static std::vector<std::unique_ptr<LAMMPS_NS::LAMMPS>> instances;
  return instances;
}

LAMMPS_NS::LAMMPS* start() {
  std::array<std::string, 5> words{"flowslide", "-log", "none", "-screen", "none"};
  std::array<char*, 5> arguments;
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  // Each instance after the first registers the contact models again and complains of it in hundreds of lines.
  const auto state = std::cerr.rdstate();
  std::cerr.setstate(std::ios::failbit);
  auto* instance = new LAMMPS_NS::LAMMPS(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_WORLD);
  std::cerr.clear(state);
  return instance;
}

}  // namespace

void ensure_mpi() { session(); }

MPI_Comm communicator_at_end() { return may_have_ranks() ? session().at_end() : MPI_COMM_NULL; }

int mpi_rank() {
  if (!may_have_ranks()) return 0;
  ensure_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int mpi_ranks() {
  if (!may_have_ranks()) return 1;
  ensure_mpi();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

LiggghtsInstance::LiggghtsInstance(std::filesystem::path log) : log_(std::move(log)) {
  ensure_mpi();
  const CLocale decimal_point;
  errors_before_ = liggghts_activity().errors;
  if (idle().empty()) {
    enter("starting");
    instance_ = start();
  } else {
    instance_ = idle().back().release();
    idle().pop_back();
    command("clear");
  }
  open_log();
}

LiggghtsInstance::~LiggghtsInstance() {
  // After an error LIGGGHTS expects the process to end, and what it holds is in no state to be cleared or deleted.
  if (liggghts_activity().errors == errors_before_) idle().emplace_back(instance_);
}

void LiggghtsInstance::enter(std::string activity) const {
  liggghts_activity().doing = std::move(activity);
  liggghts_activity().log = log_;
}

/// What LIGGGHTS' command `log` does, whose parser knows no path with quotes, "$" or "&".
void LiggghtsInstance::open_log() {
  int reason = 0;
  if (mpi_rank() == 0) {
    if (instance_->logfile) std::fclose(instance_->logfile);
    instance_->logfile = std::fopen(log_.c_str(), "w");
    if (!instance_->logfile) reason = errno;
    instance_->universe->ulogfile = instance_->logfile;
  }
  MPI_Bcast(&reason, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if (reason == 0) return;
  idle().emplace_back(instance_);
  throw EngineError(fmt::format("LIGGGHTS cannot write its log {}: {}", log_.string(), std::strerror(reason)));
}

void LiggghtsInstance::command(const std::string& line) {
  const CLocale decimal_point;
  enter("command '" + line + "'");
  instance_->input->one(line.c_str());
}

}  // namespace flowslide
