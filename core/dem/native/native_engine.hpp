// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "dem/engine.hpp"
#include "dem/native/boundaries.hpp"
#include "dem/native/contact_pass.hpp"
#include "dem/native/pair_list.hpp"

namespace flowslide {

/// This project's own engine: the same law, scheme and order of operations as LIGGGHTS with histories cleared at
/// separation, in tiles of contacts for wide vectors (see native/contact_pass.hpp). Second order in dt_L without
/// dashpots, which see the velocities of the half step and make it first order. Same bits for any skin, any time of
/// building the list and any instruction set. One thread; ranks of MPI each compute the same.
class NativeEngine : public Engine {
 public:
  /// `first_skin`: what the list reaches beyond touching at first, as a share of the smallest diameter.
  explicit NativeEngine(double first_skin = 0.01);
  ~NativeEngine() override;

  void load(const Assembly& assembly, const EngineSettings& settings) override;
  Assembly save() const override;
  void set(const EngineSettings& settings) override;
  const EngineSettings& settings() const override { return settings_; }
  void move(const BoundaryMotion& motion) override;
  void run(std::int64_t steps) override;
  CellStress cell_stress() const override;
  Cell cell() const override;
  std::uint64_t count_grains() const override;
  std::string name() const override { return "native"; }
  std::string version() const override;

 private:
  void prepare_law();
  void fold();
  void rebuild();
  void move_grains(native::MotionPart part);
  void evaluate_forces(bool last);

  double first_skin_;
  EngineSettings settings_;
  std::vector<Role> role_;
  std::vector<native::Body> bodies_;  ///< two more than grains: they pad the pair list
  std::vector<native::Load> loads_;
  std::unique_ptr<native::PairList> list_;
  std::unique_ptr<native::Boundaries> boundaries_;
  native::ContactPass contact_pass_;
  native::MotionPass motion_pass_;
  std::vector<double> kick_, twist_;  ///< dt/2 m and dt/2 I_s; 0 for glued grains
  native::LawConstants law_{};
  native::LawVariant variant_ = native::LawVariant::sliding_and_rolling;
  double skin_left_ = 0.0;     ///< m that two neighbours may still approach before the list is built anew
  double skin_ = 0.0;          ///< m, of the next list
  std::int64_t list_age_ = 0;  ///< steps since the list was built
  double smallest_diameter_ = 0.0, largest_diameter_ = 0.0;  ///< m
  double virial_[2] = {0.0, 0.0};                            ///< of the last step, N m
};

}  // namespace flowslide
