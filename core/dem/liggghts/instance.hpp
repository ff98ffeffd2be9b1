// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <mpi.h>

#include <filesystem>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// One LIGGGHTS simulation on all ranks of a communicator. It writes its log to a file and nothing to the screen.
/// Errors in LIGGGHTS throw EngineError; the message gives the command and the log.
class LiggghtsInstance {
 public:
  /// Uses a copy of `communicator`; collective over it. Throws std::system_error if the log cannot be written.
  explicit LiggghtsInstance(std::filesystem::path log, MPI_Comm communicator = MPI_COMM_SELF);
  ~LiggghtsInstance();
  LiggghtsInstance(const LiggghtsInstance&) = delete;
  LiggghtsInstance& operator=(const LiggghtsInstance&) = delete;

  void command(const std::string& line);
  /// Records the next activity of LIGGGHTS, for messages of errors that no command causes.
  void enter(std::string activity) const;

  LAMMPS_NS::LAMMPS& operator*() const { return *instance_; }
  LAMMPS_NS::LAMMPS* operator->() const { return instance_; }
  const std::filesystem::path& log() const { return log_; }
  /// The copy of the communicator.
  MPI_Comm communicator() const;

 private:
  void open_log();

  std::filesystem::path log_;
  LAMMPS_NS::LAMMPS* instance_ = nullptr;
};

}  // namespace flowslide
