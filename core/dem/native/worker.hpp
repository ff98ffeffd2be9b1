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
  /// Double-buffered grain state: buffer 0 is `bodies` in double and `first_buffer` in float, buffer 1 is
  /// `second_buffer`. All workers read the current buffer; each writes only its own grains to the next one, so that one
  /// barrier per step suffices. With one worker `second_buffer` is empty, and `state` returns buffer 0 for both
  /// numbers.
  std::vector<Body<Real>> first_buffer, second_buffer;
  std::vector<double> kick, twist;  ///< dt/(2 m) and dt/(2 I_s); 0 for glued grains
  double time_step = 0.0;           ///< dt_L, s
  std::vector<Moments> moments;     ///< of each block at the end of the last run
  std::vector<AcrossFaces> across;  ///< of each block at the end of the last run (see ContactPass), N m
  std::vector<std::uint32_t> top_layer;
  LawConstants<Real> law{};
  double smallest_diameter = 0.0, largest_diameter = 0.0;  ///< m

  /// Copies `bodies` to the buffers that this number of workers needs.
  void fill_buffers(std::size_t workers);
  /// The grains in a buffer, 0 or 1. Before a run the present state is in buffer 0.
  std::vector<Body<Real>>& state(int buffer) {
    if (buffer == 1 && !second_buffer.empty()) return second_buffer;
    if constexpr (std::is_same_v<Real, double>)
      return bodies;
    else
      return first_buffer;
  }
  /// The same grains in double.
  std::vector<Body<double>>& state_in_double(int buffer) {
    if constexpr (std::is_same_v<Real, double>)
      return state(buffer);
    else
      return bodies;
  }
  /// Moves the state at the end of a run from its last buffer to buffer 0.
  void end_run(int buffer) {
    if (buffer == 1 && !second_buffer.empty()) std::swap(state(0), second_buffer);
  }
};

/// The part of one thread in a step. A worker moves the grains of its range and evaluates every contact of these
/// grains, in the order of all pairs: the bits of a grain therefore do not depend on its owner. Both workers evaluate a
/// contact between two ranges; each uses the forces on its own grain.
template <typename Real>
class Worker {
 public:
  /// `first_allowance` (m) is the first allowed deviation of a grain at rest before the list is built anew.
  Worker(const GrainRange& range, Grains<Real>& grains, const Boundaries& boundaries, double first_allowance,
         const Passes<Real>& passes);

  /// First half of a step: half kicks and drift of the own grains, from the other buffer to `buffer`. `first` is true
  /// if the last half kick of the step before is already done.
  void begin(bool first, int buffer);
  /// After a barrier: combines the results of the first half of all workers, and builds the list anew if needed.
  void update_list(const std::vector<Worker>& all, int buffer);
  /// Second half of the last step of a run: sums the loads of the own grains, and the moments and sums in Grains.
  void evaluate(int buffer);
  /// Second half of a step and first half of the next step, in one pass over pairs and grains.
  void evaluate_and_begin(int buffer);
  /// The last half kick of the last step of a run, for the own grains in `bodies`.
  void end(std::vector<Body<double>>& bodies) const;
  /// Sums the moments of a part of the own grains, block by block.
  void measure(const GrainRange& part, int buffer);
  /// Adds the forces of the top layer and of the planes on the grains of the range to `sums`, and subtracts the moments
  /// of drag. Velocities are those of the half step.
  void add_boundary_forces(StressSums& sums) const;
  /// Appends the histories of the touching pairs of the range. In float it also determines which are at their caps.
  /// `half_step` are the grains with the velocities of the last evaluation of forces.
  void add_histories(const std::vector<Body<Real>>& half_step, std::vector<ContactHistory>& contacts) const;

  /// Searches all pairs and builds the list from them.
  void rebuild(int buffer);
  /// Largest distance of the centres of two grains in a list, m.
  static double longest_reach(const Grains<Real>& grains);
  const GrainRange& range() const { return range_; }
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
  struct StepResults {
    double fluctuation_squared = 0.0;  ///< see MotionExtremes, m^2/s^2
    double slack = 0.0, search_slack = 0.0;  ///< smallest remaining allowance of both watches if measured, m
    std::vector<Fold> folds;
  };
  /// The arrays of a part of the range for a pass from one buffer to another; `from` equals `to` for passes that only
  /// read.
  MovingGrains<Real> moving(const GrainRange& part, int from, int to);
  /// Starts to fetch the grains of other workers that the list contains. Their lines are in the caches of other cores,
  /// and all on their way at once they take a tenth of the time that they take one by one. No result depends on it.
  void fetch_foreign(int buffer) const;
  /// Sums the loads of the own grains. Calls then(part) for each part, in order, as soon as no later pair contains its
  /// grains.
  template <typename Then>
  void sum_loads(int buffer, AcrossFaces* across, Then then);
  /// After the first half of a step: moves the boundaries and folds grains into the cell.
  void finish_first_half(const MotionExtremes& extremes, const MeanFlow& flow, int buffer);
  void fold(std::vector<Body<double>>& bodies, std::vector<Fold>& folds);
  /// Shifts a grain of a sheared cell along x after a fold by `layers` heights (1 or -1).
  void cross_the_shear(Body<double>& body, std::size_t grain, int layers);
  /// Sets the allowances of all grains from their velocities.
  void set_allowances(const std::vector<Body<Real>>& bodies);
  /// Builds the list from the pairs of the last search.
  void build(int buffer);

  GrainRange range_;
  Grains<Real>& grains_;
  Boundaries boundaries_;
  Passes<Real> passes_;
  PairList<Real> list_;
  std::vector<Load<Real>> loads_;       ///< of each grain; those of other ranges are partial sums and unused
  std::vector<AcrossFaces> across_;     ///< of each block; those of other ranges are partial sums and unused
  std::array<StepResults, 2> results_;  ///< of the steps to either buffer
  std::vector<double> allowance_, search_allowance_;  ///< of each grain in the list and in the search, m
  DisplacementCheck<Real> list_check_, search_check_;  ///< of the list and of the search
  double allowance_at_rest_;                          ///< allowance of a grain at rest in the next list, m
};

}  // namespace flowslide::native
