// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "dem/native/grain_range.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// The neighbour list of a range: all pairs whose gap is below the sum of the allowances of both grains and of which
/// the range owns at least one grain. Pairs of one glued layer are excluded. Sorted by (first, second), first < second.
/// Open pairs contribute exact zeros, so that results depend neither on the allowances nor on the time of building. A
/// list is built from the pairs of a search with wider allowances. A search costs more and is rarer (Pall and Hess
/// 2013, doi 10.1016/j.cpc.2013.06.003, prune their lists in this way). `Real` is the precision of constants and
/// histories.
template <typename Real>
class PairList {
 public:
  using Bodies = std::vector<Body<Real>>;
  explicit PairList(const GrainRange& range) : range_(range) {}

  /// Finds the pairs from which lists are built. `bodies` are folded into the cell; the last two are no grains but pad
  /// the last tile. `allowance` (m), shape (n), is that of each grain. The pairs store what `law` needs. Call `build`
  /// next.
  void search(const Cell& cell, const Bodies& bodies, const std::vector<Role>& role,
              const std::vector<double>& allowance, ContactLaw law);
  /// Builds the list and keeps the histories of pairs that were in the list before. `allowance` (m), shape (n): at most
  /// the remaining allowance of the search for each grain.
  void build(const Cell& cell, const Bodies& bodies, const std::vector<double>& allowance);
  /// Renumbers the images of the pairs of a grain that was folded by `periods` (1 or -1) along an axis.
  void carry(std::uint32_t grain, int axis, int periods);
  /// Replaces all histories by `contacts`, sorted by (first, second). Precondition: the list was built.
  void set_histories(const std::vector<ContactHistory>& contacts);
  /// Clears the histories that this variant of the law does not use.
  void forget(LawVariant variant);
  /// Appends the histories of touching pairs whose first grain the range owns. `eased` is a copy of this list after a
  /// contact pass with a time step of 0 and with the friction multiplied by (1 - easing). A history that is shorter in
  /// this copy is at its cap. Without `eased`, caps are unknown.
  void add_histories(const Bodies& bodies, std::vector<ContactHistory>& contacts,
                     const PairList* eased = nullptr) const;
  static constexpr double easing = 1e-6;

  /// The input of the contact pass, valid until the list changes. `cell` gives the present periods.
  PairView<Real> view(const Cell& cell);
  std::size_t pairs() const { return pairs_; }
  /// The grains of other ranges in the pairs of the last search, sorted.
  const std::vector<std::uint32_t>& foreign() const { return foreign_; }
  /// Separation x_first - x_second of a pair, with the nearest image at the last build, m.
  Vector3 separation(std::size_t pair, const Bodies& bodies) const;

 private:
  /// A pair of the search, with the constants of its law.
  struct Candidate {
    NearPair pair;
    double first_radius, second_radius;
    Real effective_radius, root_effective_mass, root_rolling_inertia, root_scale;
  };
  struct Columns {
    std::vector<std::uint32_t> first, second;
    std::vector<std::uint8_t> image;
    std::vector<double> first_radius, second_radius;
    std::vector<Real> effective_radius, root_effective_mass, root_rolling_inertia;
    std::vector<Real> root_scale;  ///< empty for a law whose scale changes with the overlap
    std::array<std::vector<Real>, 6> history;  ///< three components of the spring, three of the rolling torque
    void resize(std::size_t pairs, bool constant_scale);
    void put(std::size_t p, const Candidate& candidate, std::uint8_t image_now);
  };
  Candidate candidate(const NearPair& pair, const Bodies& bodies) const;
  void find_foreign();
  void keep_histories(std::size_t old_pairs);
  Vector3 history(std::size_t first_component, std::size_t pair) const;
  void set_shifts(const Cell& cell);

  GrainRange range_;
  ContactLaw law_ = ContactLaw::hertz;  ///< of the last search
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> foreign_;
  std::vector<int> folded_;  ///< change of the image number of each grain's pairs by folds since the search
  Candidate nobody_{};       ///< padding pair
  std::size_t pairs_ = 0;
  Columns columns_, old_;  ///< of this list and of the one before; its memory is used again
  alignas(32) double shift_[27][4] = {};
};

}  // namespace flowslide::native
