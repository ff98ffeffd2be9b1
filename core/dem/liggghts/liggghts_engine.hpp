// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <memory>

#include "dem/engine.hpp"
#include "dem/liggghts/commands.hpp"
#include "dem/liggghts/instance.hpp"

namespace flowslide {

class SteeringFix;

/// The reference engine: LIGGGHTS (Kloss et al. 2012, doi 10.1504/PCFD.2012.047457) in this process.
class LiggghtsEngine : public Engine {
 public:
  /// `log` is the log file of LIGGGHTS. The ranks of `communicator` divide the grains; MPI_COMM_SELF: one process. The
  /// communicator must live as long as the engine. Starts MPI unless it is started.
  explicit LiggghtsEngine(std::filesystem::path log, SeparatedHistory separated = SeparatedHistory::cleared,
                          MPI_Comm communicator = MPI_COMM_SELF);
  ~LiggghtsEngine() override;

  void load(const Assembly& assembly, const EngineSettings& settings) override;
  Assembly save() const override;
  void set(const EngineSettings& settings) override;
  const EngineSettings& settings() const override { return settings_; }
  void move(const BoundaryMotion& motion) override;
  void run(std::int64_t steps) override;
  CellStress cell_stress() const override;
  Cell cell() const override;
  std::uint64_t count_grains() const override;
  std::string name() const override { return separated_ == SeparatedHistory::cleared ? "liggghts" : "liggghts-stock"; }
  std::string version() const override;

 private:
  void create_grains(const Assembly& assembly);
  void install_steering(const Cell& cell);
  void restore(const Assembly& assembly);
  void advance(int steps);

  std::filesystem::path log_;
  SeparatedHistory separated_;
  MPI_Comm communicator_;
  EngineSettings settings_;
  BoundaryMotion motion_;
  std::size_t grains_ = 0;
  std::unique_ptr<LiggghtsInstance> instance_;
  SteeringFix* steering_ = nullptr;  ///< owned by LIGGGHTS
};

}  // namespace flowslide
