// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "dem/native/boundaries.hpp"
#include "dem/native/pair_list.hpp"
#include "dem/native/passes.hpp"
#include "dem/native/stray_watch.hpp"
#include "dem/stress_sums.hpp"

namespace flowslide::native {

/// The grains as all workers see them.
template <typename Real>
struct Grains {
  std::vector<Role> role;
  std::vector<Body<double>> bodies;  ///< between runs; two more than grains: they pad pair lists
  /// What workers read of all grains, each written by its owner alone: in float `rounded`, in double `bodies`. Several
  /// workers write this and `other` by turns, so that one barrier a step is enough; of one worker `other` is empty.
  std::vector<Body<Real>> rounded, other;
  std::vector<double> kick, twist;  ///< dt/2 m and dt/2 I_s; 0 for glued grains
  double time_step = 0.0;           ///< dt_L, s
  std::vector<Moments> moments;     ///< of each block, at the end of the last run
  std::vector<AcrossFaces> across;  ///< of each block, then (see ContactPass), N m
  std::vector<std::uint32_t> top_layer;
  LawConstants<Real> law{};
  LawVariant variant = LawVariant::sliding_and_rolling;
  double smallest_diameter = 0.0, largest_diameter = 0.0;  ///< m

  /// Makes the arrays that workers read, for so many of them.
  void publish(std::size_t workers);
  /// What workers read at a turn, 0 or 1; a run begins after turn 0.
  std::vector<Body<Real>>& seen(int turn) {
    if (turn == 1 && !other.empty()) return other;
    if constexpr (std::is_same_v<Real, double>)
      return bodies;
    else
      return rounded;
  }
  /// The grains in double at a turn.
  std::vector<Body<double>>& exact(int turn) {
    if constexpr (std::is_same_v<Real, double>)
      return seen(turn);
    else
      return bodies;
  }
  /// Makes the last turn of a run turn 0.
  void end_run(int turn) {
    if (turn == 1 && !other.empty()) std::swap(seen(0), other);
  }
};

/// One thread's part of a step: it moves the grains of its share and evaluates every contact that touches one of them,
/// in the order of all pairs, so that the bits of a grain do not depend on who owns it. Contacts between two shares are
/// evaluated by both workers; each keeps its own side.
template <typename Real>
class Worker {
 public:
  /// `first_allowance`: by how much a grain may stray at first before the list is built anew, m.
  Worker(const Share& share, Grains<Real>& grains, const Boundaries& boundaries, double first_allowance,
         const Passes<Real>& passes);

  /// First half: half kicks and drift of the own grains, to this turn from the other.
  void begin(bool first, int turn);
  /// Takes note of what all workers have done; after a barrier.
  void meet(const std::vector<Worker>& all, int turn);
  /// Second half: sums the loads of the own grains and measures them, see Grains: for the last step of a run.
  void evaluate(int turn);
  /// Second half of a step and first half of the next in one go through pairs and grains.
  void evaluate_and_begin(int turn);
  /// The half kick that is left after the last step of a run, of the own grains in `bodies`.
  void end(std::vector<Body<double>>& bodies) const;
  /// Sums the moments of a part of the own grains, block by block.
  void measure(const Share& part, int turn);
  /// Adds to `sums` what the top layer and planes do to the share's grains, and takes the moments of drag out of them.
  /// Velocities are those of the half step.
  void add_boundary_forces(StressSums& sums) const;
  /// Adds the histories of the share's pairs that touch. In float it finds out which are at their caps. `half_step`:
  /// the grains as the last evaluation of forces saw them.
  void add_histories(const std::vector<Body<Real>>& half_step, std::vector<ContactHistory>& contacts) const;

  /// Searches all pairs and builds the list anew.
  void rebuild(int turn);
  /// Largest distance of the centres of two grains in a list, m.
  static double longest_reach(const Grains<Real>& grains);
  const Share& share() const { return share_; }
  Boundaries& boundaries() { return boundaries_; }
  const Boundaries& boundaries() const { return boundaries_; }
  PairList<Real>& list() { return list_; }
  std::vector<Load<Real>>& loads() { return loads_; }
  const std::vector<Load<Real>>& loads() const { return loads_; }

 private:
  struct Fold {
    std::uint32_t grain;
    int axis, periods;
  };
  /// What others must know of a move.
  struct News {
    double fluctuation_squared = 0.0;  ///< of the velocities, m^2/s^2
    double slack = 0.0, search_slack = 0.0;  ///< what the watches measured, if they did, m
    std::vector<Fold> folds;
  };
  /// A part of the share on its way from one turn to the next; `from` is `to` for passes that only look.
  MovingGrains<Real> moving(const Share& part, int from, int to);
  /// Sums the loads of the own grains and calls then(part) for blocks of them that no further pair has, in their order.
  template <typename Then>
  void sum_loads(int turn, AcrossFaces* across, Then then);
  /// After the first half of a step: moves the boundaries and puts grains back into the cell.
  void arrive(const MotionExtremes& extremes, const MeanFlow& flow, int turn);
  void fold(std::vector<Body<double>>& bodies, std::vector<Fold>& folds);
  /// A grain was folded by so many heights of the cell, 1 or -1.
  void cross_the_shear(Body<double>& body, std::size_t grain, int layers);
  void allow(const std::vector<Body<Real>>& bodies);
  /// Builds the list from the pairs of the last search.
  void build(int turn);

  Share share_;
  Grains<Real>& grains_;
  Boundaries boundaries_;
  Passes<Real> passes_;
  PairList<Real> list_;
  std::vector<Load<Real>> loads_;  ///< those of others' grains are partial sums that nobody reads
  std::vector<AcrossFaces> across_;  ///< of each block; those of others are partial sums as well
  std::array<News, 2> news_;
  std::vector<double> allowance_, search_allowance_;  ///< of each grain in the list and in the search, m
  StrayWatch<Real> watch_, search_watch_;             ///< of the list, and of the search it is built from
  double allowance_at_rest_;                          ///< m, of a grain at rest in the next list
};

}  // namespace flowslide::native
