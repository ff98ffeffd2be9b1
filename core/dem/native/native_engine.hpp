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

/// How the native engine goes about its work. No bit of a result depends on it.
struct NativeOptions {
  int threads = 0;                   ///< 0: one below 10 000 grains, else one for each core
  double first_allowance = 1e-3;     ///< by how much a grain may stray at first before the pair list is built anew, in
                                     ///< smallest diameters
  std::string instruction_set = {};  ///< empty: the widest that the processor has
};

/// This project's own engine: the same law, scheme and order of operations as LIGGGHTS with histories cleared at
/// separation, in tiles of contacts for wide vectors (see native/contact_pass.hpp). Second order in dt_L without
/// dashpots, which see the velocities of the half step and make it first order. Same bits for any number of threads,
/// time of building the pair list, compiler and instruction set. Ranks of MPI each compute the same.
///
/// `Real` is the precision of the law, the histories and the sums of forces; positions, gaps and the integration are in
/// double. In float, forces carry rounding of 1e-7 of the largest: prepare samples in double. save() then says which
/// histories are at their caps, because a dashpot acts below the cap alone and rounding would hide on which side a
/// contact is. Forces that `evaluate_contact_forces` finds from the saved state agree with those of the step to 2e-6 of
/// the largest contact force, also at 4 m/s, where velocities are rounded to 2e-7 m/s.
///
/// A cell that is periodic along z is sheared across its faces (Lees and Edwards 1972). When its rate changes, every
/// mobile grain gets the change of the linear field about the middle of the cell; else the faces, which are no place in
/// the sample, would drive it like walls. It is the impulse of the SLLOD equations of motion (P. J. Daivis and B. D.
/// Todd, J. Chem. Phys. 124 (2006) 194103), which at a constant rate are Newton's.
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
  void hire(const Cell& cell);
  void prepare_law();
  std::vector<native::Share> shares(int threads) const;
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
  bool half_step_ = false;            ///< velocities are those of the last half step: its end waits for the next begin
  bool law_is_new_ = true;            ///< since the last run: histories may be there that it does not keep
  std::vector<std::uint32_t> glued_;  ///< grains that are not mobile
  StressSums sums_;                   ///< of the last step
  std::size_t inside_ = 0;
};

using DoubleEngine = NativeEngine<double>;
using MixedEngine = NativeEngine<float>;

}  // namespace flowslide
