// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "dem/native/share.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// The neighbour list: all pairs nearer than touching plus the allowances of both grains of which a share owns at least
/// one, sorted by (first, second), first < second, pairs of one glued layer left out. Open pairs add exact zeros, so
/// results depend neither on the allowances nor on when it is built. It is built from the pairs of a search with wider
/// allowances, which costs more (Pall and Hess 2013, doi 10.1016/j.cpc.2013.06.003, prune theirs alike). `Real` is the
/// precision of constants and histories.
template <typename Real>
class PairList {
 public:
  using Bodies = std::vector<Body<Real>>;
  explicit PairList(const Share& share) : share_(share) {}

  /// Finds the pairs that lists are built from, of `bodies` that are folded into the cell; the last two stand in for no
  /// grain and pad the last tile. `allowance`: m, of each grain. Build the list next.
  void search(const Cell& cell, const Bodies& bodies, const std::vector<Role>& role,
              const std::vector<double>& allowance);
  /// Builds the list anew and keeps the histories of pairs that were in it before. `allowance`: m, of each grain; no
  /// more than what is left of those of the search.
  void build(const Cell& cell, const Bodies& bodies, const std::vector<double>& allowance);
  /// A grain was folded by so many periods, 1 or -1, along an axis: its pairs meet other images.
  void carry(std::uint32_t grain, int axis, int periods);
  /// Forgets all histories and takes these, sorted by (first, second); the list must have been built.
  void set_histories(const std::vector<ContactHistory>& contacts);
  /// Forgets the histories that a law without these parts does not keep.
  void forget(LawVariant variant);
  /// Adds the histories of the pairs that touch and whose first grain the share owns. `eased`: a copy of this list
  /// after a contact pass with no time step and friction lowered to (1 - easing) of itself. A history that is shorter
  /// there is at its cap. Without it, caps are unknown.
  void add_histories(const Bodies& bodies, std::vector<ContactHistory>& contacts,
                     const PairList* eased = nullptr) const;
  static constexpr double easing = 1e-6;

  /// What the contact pass needs; valid until the list changes. `cell` gives the periods of this moment.
  PairView<Real> view(const Cell& cell);
  std::size_t pairs() const { return pairs_; }
  /// Separation x_first - x_second of a pair, nearest image as of the last build, m.
  Vector3 separation(std::size_t pair, const Bodies& bodies) const;

 private:
  /// A pair that was found, with the constants of its law.
  struct Candidate {
    NearPair pair;
    double first_radius, second_radius;
    Real effective_radius, root_effective_mass, root_rolling_inertia;
  };
  struct Columns {
    std::vector<std::uint32_t> first, second;
    std::vector<std::uint8_t> image;
    std::vector<double> first_radius, second_radius;
    std::vector<Real> effective_radius, root_effective_mass, root_rolling_inertia;
    std::array<std::vector<Real>, 6> history;  ///< spring, rolling torque
    void resize(std::size_t pairs);
    void put(std::size_t p, const Candidate& candidate, std::uint8_t image_now);
  };
  static Candidate candidate(const NearPair& pair, const Bodies& bodies);
  void keep_histories(std::size_t old_pairs);
  Vector3 history(std::size_t first_component, std::size_t pair) const;
  void set_shifts(const Cell& cell);

  Share share_;
  std::vector<Candidate> candidates_;
  std::vector<int> folded_;  ///< by how much each grain's folds since the search change the image of its pairs
  Candidate nobody_{};       ///< pads
  std::size_t pairs_ = 0;
  Columns columns_, old_;  ///< of this list and the one before, whose memory is used again
  alignas(32) double shift_[27][4] = {};
};

}  // namespace flowslide::native
