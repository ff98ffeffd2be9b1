// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/instance.hpp"

#include <input.h>
#include <lammps.h>
#include <mpi.h>

#include <array>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dem/engine.hpp"
#include "dem/liggghts/error_bridge.hpp"

namespace flowslide {
namespace {

class MpiSession {
 public:
  MpiSession() {
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (!initialized) MPI_Init(nullptr, nullptr);
    owner_ = !initialized;
  }
  ~MpiSession() {
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (owner_ && !finalized) MPI_Finalize();
  }

 private:
  bool owner_ = false;
};

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

void ensure_mpi() { static MpiSession session; }

int mpi_rank() {
  ensure_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int mpi_ranks() {
  ensure_mpi();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

LiggghtsInstance::LiggghtsInstance(std::filesystem::path log) : log_(std::move(log)) {
  ensure_mpi();
  errors_before_ = liggghts_activity().errors;
  if (idle().empty()) {
    enter("starting");
    instance_ = start();
  } else {
    instance_ = idle().back().release();
    idle().pop_back();
    command("clear");
  }
  command("log \"" + log_.string() + "\"");
}

LiggghtsInstance::~LiggghtsInstance() {
  // After an error LIGGGHTS expects the process to end, and what it holds is in no state to be cleared or deleted.
  if (liggghts_activity().errors == errors_before_) idle().emplace_back(instance_);
}

void LiggghtsInstance::enter(std::string activity) const {
  liggghts_activity().doing = std::move(activity);
  liggghts_activity().log = log_;
}

void LiggghtsInstance::command(const std::string& line) {
  enter("command '" + line + "'");
  instance_->input->one(line.c_str());
}

}  // namespace flowslide
