// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/share.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// The neighbour list: all pairs nearer than touching plus the allowances of both grains of which a share owns at least
/// one, sorted by (first, second), first < second, pairs of one glued layer left out. Open pairs add exact zeros, so
/// results depend neither on the allowances nor on when it is built. `Real` is the precision of constants and histories.
template <typename Real>
class PairList {
 public:
  using Bodies = std::vector<Body<Real>>;
  explicit PairList(const Share& share) : share_(share) {}

  /// Builds the list anew from `bodies` (folded into the cell by the caller; the last two stand in for no grain and pad
  /// the last tile) and keeps the histories of pairs that were in the list before. `allowance`: m, of each grain.
  void build(const Cell& cell, const Bodies& bodies, const std::vector<Role>& role,
             const std::vector<double>& allowance);
  /// A grain was folded by so many periods, 1 or -1, along an axis: its pairs meet other images.
  void carry(std::uint32_t grain, int axis, int periods);
  /// Forgets all histories and takes these, sorted by (first, second); the list must have been built.
  void set_histories(const std::vector<ContactHistory>& contacts);
  /// Forgets the histories that a law without these parts does not keep.
  void forget(LawVariant variant);
  /// Adds the histories of the pairs that touch and whose first grain the share owns.
  void add_histories(const Bodies& bodies, std::vector<ContactHistory>& contacts) const;

  /// What the contact pass needs; valid until the list changes. `cell` gives the periods of this moment.
  PairView<Real> view(const Cell& cell);
  std::size_t pairs() const { return pairs_; }
  /// Separation x_first - x_second of a pair, nearest image as of the last build, m.
  Vector3 separation(std::size_t pair, const Bodies& bodies) const;

 private:
  struct Columns {
    std::vector<std::uint32_t> first, second;
    std::vector<std::uint8_t> image;
    std::array<std::vector<Real>, 6> history;  ///< spring, rolling torque
    void clear();
    void append(std::uint32_t i, std::uint32_t j, std::uint8_t shift);
  };
  void keep_histories(std::size_t old_pairs);
  void fill_constants(const Bodies& bodies);
  void set_shifts(const Cell& cell);

  Share share_;
  std::size_t pairs_ = 0;
  Columns columns_, old_;  ///< of this list and the one before, whose memory is used again
  std::vector<double> first_radius_, second_radius_;
  std::vector<Real> effective_radius_, root_effective_mass_, root_rolling_inertia_;
  alignas(32) double shift_[27][4] = {};
};

}  // namespace flowslide::native
