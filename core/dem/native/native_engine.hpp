// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "dem/engine.hpp"
#include "dem/native/thread_team.hpp"
#include "dem/native/worker.hpp"
#include "dem/stress_sums.hpp"

namespace flowslide {

/// Options of the native engine. No bit of a result depends on them.
struct NativeOptions {
  int threads = 0;                   ///< 0: one thread below 10 000 grains, otherwise one per core
  double first_allowance = 1e-3;     ///< first allowed deviation of a grain at rest before the pair list is built
                                     ///< anew, in smallest diameters
  std::string instruction_set = {};  ///< empty: the widest of the processor
};

/// The engine of this project: the same law, scheme and order of operations as LIGGGHTS with histories cleared at
/// separation. It computes contacts in tiles for wide vectors (see native/contact_pass.hpp). It is of second order in
/// dt_L without dashpots. Dashpots use the velocities of the half step, which reduces the order to one. Results have
/// the same bits for any number of threads, rebuild time of the pair list, compiler and instruction set. Every MPI rank
/// computes the whole sample.
///
/// `Real` is the precision of the law, the histories and the sums of forces. Positions, gaps and the integration are in
/// double. With float, forces have a rounding error of 1e-7 of the largest force: prepare samples in double. save()
/// then states which histories are at their caps, because dashpots act only below the cap and rounding may hide the
/// side of the cap. From the saved state `evaluate_contact_forces` computes forces within 2e-6 of the largest contact
/// force of the step, also at 4 m/s, where velocities are rounded to 2e-7 m/s.
///
/// A cell that is periodic along z is sheared across its faces (Lees and Edwards 1972). When the shear rate changes,
/// every mobile grain receives the change of the linear field about the middle of the cell. Otherwise the faces would
/// drive the sample like walls, although their position in the sample is arbitrary. This is the impulse of the SLLOD
/// equations of motion (P. J. Daivis and B. D. Todd, J. Chem. Phys. 124 (2006) 194103), which at a constant rate are
/// Newton's.
template <typename Real>
class NativeEngine : public Engine {
 public:
  explicit NativeEngine(const NativeOptions& options = {});
  ~NativeEngine() override;

  void load(const Assembly& assembly, const EngineSettings& settings) override;
  Assembly save() const override;
  void set(const EngineSettings& settings) override;
  const EngineSettings& settings() const override { return settings_; }
  void move(const BoundaryMotion& motion) override;
  void run(std::int64_t steps) override;
  CellStress cell_stress() const override;
  Cell cell() const override;
  std::uint64_t count_grains() const override { return inside_; }
  std::string name() const override;
  std::string version() const override;
  int threads() const { return team_ ? team_->size() : 1; }

 private:
  void take_grains(const Assembly& assembly, const Cell& cell);
  void start_workers(const Cell& cell);
  void prepare_law();
  std::vector<native::GrainRange> ranges(int threads) const;
  void take_loads(const Assembly& assembly);
  void take_last_step(const Assembly& assembly);
  std::vector<native::Body<Real>> at_half_step() const;
  void finish_step();
  void slide_faces(const Vector3& sliding);
  void sum_up();

  NativeOptions options_;
  EngineSettings settings_;
  BoundaryMotion motion_;
  native::Grains<Real> grains_;
  std::vector<native::Worker<Real>> workers_;
  std::unique_ptr<native::ThreadTeam> team_;
  bool half_step_ = false;            ///< true: velocities are at the half step, without the last half kick
  bool law_is_new_ = true;            ///< true: the law may have changed since the last run; clear unused histories
  std::vector<std::uint32_t> glued_;  ///< indices of the glued grains
  StressSums sums_;                   ///< sums of the last step
  std::size_t inside_ = 0;
};

using DoubleEngine = NativeEngine<double>;
using MixedEngine = NativeEngine<float>;

}  // namespace flowslide
