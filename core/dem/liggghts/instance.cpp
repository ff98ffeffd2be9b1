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
#include <cstring>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "dem/engine.hpp"
#include "dem/liggghts/c_locale.hpp"
#include "dem/liggghts/error_bridge.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

/// Unused instances, which are cleared and used again.
std::vector<std::unique_ptr<LAMMPS_NS::LAMMPS>>& idle() {
  static std::vector<std::unique_ptr<LAMMPS_NS::LAMMPS>> instances;
  return instances;
}

LAMMPS_NS::LAMMPS* start() {
  std::array<std::string, 5> words{"flowslide", "-log", "none", "-screen", "none"};
  std::array<char*, 5> arguments;
  for (std::size_t i = 0; i < words.size(); ++i) arguments[i] = words[i].data();
  // Each instance after the first registers the contact models again and prints hundreds of warnings about it.
  const auto state = std::cerr.rdstate();
  std::cerr.setstate(std::ios::failbit);
  auto* instance = new LAMMPS_NS::LAMMPS(static_cast<int>(arguments.size()), arguments.data(), MPI_COMM_WORLD);
  std::cerr.clear(state);
  return instance;
}

}  // namespace

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
  // After an error LIGGGHTS expects the process to end. Its objects can then be neither cleared nor deleted.
  if (liggghts_activity().errors == errors_before_) idle().emplace_back(instance_);
}

void LiggghtsInstance::enter(std::string activity) const {
  liggghts_activity().doing = std::move(activity);
  liggghts_activity().log = log_;
}

/// Does the same as the command `log` of LIGGGHTS, whose parser does not accept quotes, "$" or "&" in a path.
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
