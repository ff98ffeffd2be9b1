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
#include "dem/native/displacement_check.hpp"
#include "dem/stress_sums.hpp"

namespace flowslide::native {

/// The grains, shared by all workers.
template <typename Real>
struct Grains {
  std::vector<Role> role;
  std::vector<Body<double>> bodies;  ///< the grains between runs, followed by two bodies that pad pair lists
  /// Double-buffered grain state. All workers read the buffer of the current turn (`rounded` in float, `bodies` in
  /// double, or `other`). Each worker writes only its own grains to the buffer of the next turn, so that one barrier
  /// per step suffices. With one worker `other` is empty.
  std::vector<Body<Real>> rounded, other;
  std::vector<double> kick, twist;  ///< dt/(2 m) and dt/(2 I_s); 0 for glued grains
  double time_step = 0.0;           ///< dt_L, s
  std::vector<Moments> moments;     ///< of each block at the end of the last run
  std::vector<AcrossFaces> across;  ///< of each block at the end of the last run (see ContactPass), N m
  std::vector<std::uint32_t> top_layer;
  LawConstants<Real> law{};
  LawVariant variant = LawVariant::sliding_and_rolling;
  double smallest_diameter = 0.0, largest_diameter = 0.0;  ///< m

  /// Fills the buffers for this number of workers.
  void publish(std::size_t workers);
  /// The buffer that workers read at a turn, 0 or 1. Before a run the present state is that of turn 0.
  std::vector<Body<Real>>& seen(int turn) {
    if (turn == 1 && !other.empty()) return other;
    if constexpr (std::is_same_v<Real, double>)
      return bodies;
    else
      return rounded;
  }
  /// The same grains in double.
  std::vector<Body<double>>& exact(int turn) {
    if constexpr (std::is_same_v<Real, double>)
      return seen(turn);
    else
      return bodies;
  }
  /// Makes the buffer of the last turn of a run that of turn 0.
  void end_run(int turn) {
    if (turn == 1 && !other.empty()) std::swap(seen(0), other);
  }
};

/// The part of one thread in a step. A worker moves the grains of its share and evaluates every contact of these
/// grains, in the order of all pairs: the bits of a grain therefore do not depend on its owner. Both workers evaluate a
/// contact between two shares; each uses the forces on its own grain.
template <typename Real>
class Worker {
 public:
  /// `first_allowance` (m) is the first allowed deviation of a grain at rest before the list is built anew.
  Worker(const Share& share, Grains<Real>& grains, const Boundaries& boundaries, double first_allowance,
         const Passes<Real>& passes);

  /// First half of a step: half kicks and drift of the own grains, from the other turn to `turn`. `first` is true if
  /// the last half kick of the step before is already done.
  void begin(bool first, int turn);
  /// After a barrier: reads the results of the first half from all workers, and builds the list anew if needed.
  void meet(const std::vector<Worker>& all, int turn);
  /// Second half of the last step of a run: sums the loads of the own grains, and the moments and sums in Grains.
  void evaluate(int turn);
  /// Second half of a step and first half of the next step, in one pass over pairs and grains.
  void evaluate_and_begin(int turn);
  /// The last half kick of the last step of a run, for the own grains in `bodies`.
  void end(std::vector<Body<double>>& bodies) const;
  /// Sums the moments of a part of the own grains, block by block.
  void measure(const Share& part, int turn);
  /// Adds the forces of the top layer and of the planes on the grains of the share to `sums`, and subtracts the moments
  /// of drag. Velocities are those of the half step.
  void add_boundary_forces(StressSums& sums) const;
  /// Appends the histories of the touching pairs of the share. In float it also determines which are at their caps.
  /// `half_step` are the grains with the velocities of the last evaluation of forces.
  void add_histories(const std::vector<Body<Real>>& half_step, std::vector<ContactHistory>& contacts) const;

  /// Searches all pairs and builds the list from them.
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
  /// Results of the first half of a step that the other workers read.
  struct News {
    double fluctuation_squared = 0.0;  ///< see MotionExtremes, m^2/s^2
    double slack = 0.0, search_slack = 0.0;  ///< smallest remaining allowance of both watches if measured, m
    std::vector<Fold> folds;
  };
  /// The arrays of a part of the share for a pass from one turn to another; `from` equals `to` for passes that only
  /// read.
  MovingGrains<Real> moving(const Share& part, int from, int to);
  /// Sums the loads of the own grains. Calls then(part) for each part, in order, as soon as no later pair contains its
  /// grains.
  template <typename Then>
  void sum_loads(int turn, AcrossFaces* across, Then then);
  /// After the first half of a step: moves the boundaries and folds grains into the cell.
  void arrive(const MotionExtremes& extremes, const MeanFlow& flow, int turn);
  void fold(std::vector<Body<double>>& bodies, std::vector<Fold>& folds);
  /// Shifts a grain of a sheared cell along x after a fold by `layers` heights (1 or -1).
  void cross_the_shear(Body<double>& body, std::size_t grain, int layers);
  /// Sets the allowances of all grains from their velocities.
  void allow(const std::vector<Body<Real>>& bodies);
  /// Builds the list from the pairs of the last search.
  void build(int turn);

  Share share_;
  Grains<Real>& grains_;
  Boundaries boundaries_;
  Passes<Real> passes_;
  PairList<Real> list_;
  std::vector<Load<Real>> loads_;  ///< of each grain; those of other shares are partial sums and unused
  std::vector<AcrossFaces> across_;  ///< of each block; those of other shares are partial sums and unused
  std::array<News, 2> news_;         ///< of both turns
  std::vector<double> allowance_, search_allowance_;  ///< of each grain in the list and in the search, m
  StrayWatch<Real> watch_, search_watch_;             ///< of the list and of the search
  double allowance_at_rest_;                          ///< allowance of a grain at rest in the next list, m
};

}  // namespace flowslide::native
