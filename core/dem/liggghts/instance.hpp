// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// One LIGGGHTS simulation in this process, on all ranks of MPI_COMM_WORLD. It writes its log to a file and nothing to
/// the screen. Errors in LIGGGHTS throw EngineError; the message gives the command and the log.
class LiggghtsInstance {
 public:
  /// Throws EngineError if the log cannot be written.
  explicit LiggghtsInstance(std::filesystem::path log);
  ~LiggghtsInstance();
  LiggghtsInstance(const LiggghtsInstance&) = delete;
  LiggghtsInstance& operator=(const LiggghtsInstance&) = delete;

  void command(const std::string& line);
  /// Records the next activity of LIGGGHTS, for messages of errors that no command causes.
  void enter(std::string activity) const;

  LAMMPS_NS::LAMMPS& operator*() const { return *instance_; }
  LAMMPS_NS::LAMMPS* operator->() const { return instance_; }
  const std::filesystem::path& log() const { return log_; }

 private:
  void open_log();

  std::filesystem::path log_;
  int errors_before_ = 0;
  LAMMPS_NS::LAMMPS* instance_ = nullptr;
};

}  // namespace flowslide
