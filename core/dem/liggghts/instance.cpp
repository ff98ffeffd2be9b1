// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/instance.hpp"

#include <error.h>
#include <input.h>
#include <lammps.h>
#include <mpi.h>

#include <array>
#include <string>
#include <utility>

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
  enter("starting");
  std::string program = "flowslide", log_flag = "-log", log_name = log_.string(), screen_flag = "-screen",
              screen_name = "none";
  std::array<char*, 5> arguments{program.data(), log_flag.data(), log_name.data(), screen_flag.data(),
                                 screen_name.data()};
  instance_ = new LAMMPS_NS::LAMMPS(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_WORLD);
}

LiggghtsInstance::~LiggghtsInstance() { delete instance_; }

void LiggghtsInstance::enter(std::string activity) const { liggghts_activity() = {std::move(activity), log_}; }

void LiggghtsInstance::command(const std::string& line) {
  enter("command '" + line + "'");
  instance_->input->one(line.c_str());
}

}  // namespace flowslide
