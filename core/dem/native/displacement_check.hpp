// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "dem/native/passes.hpp"
#include "dem/native/grain_range.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// Checks whether a pair list is still complete. The list has all pairs whose gap is below the sum of their allowances.
/// It is complete as long as no grain deviates from the mean flow by more than its allowance. The deviations are
/// bounded step by step, and measured only when the bound is used up. Every worker checks its own grains and receives
/// the results of the others, so that all workers decide the same.
template <typename Real>
class DisplacementCheck {
 public:
  /// Starts at the present positions of the grains of the range. `allowance` (m), shape (n), is that of all grains.
  void start(const GrainRange& range, const std::vector<Body<double>>& bodies, const std::vector<double>& allowance);
  /// Adds the displacement of the mean flow in a step of `time_step` (s).
  void follow(const MeanFlow& flow, double time_step) { drift_.add(flow, time_step); }
  /// Accounts for a fold of a grain by `way` (m) along an axis.
  void carry(std::size_t grain, int axis, double way) { start_[grain].position[axis] += way; }
  /// Accounts for the shift along x of a grain that was folded by `layers` heights (1 or -1) of a sheared cell: the
  /// shear offset at the start of the list. The mean drift at the new height contains the rest of the shift.
  void cross_the_shear(std::size_t grain, int layers, const Cell& cell) {
    carry(grain, 0, layers * (cell.shear_offset - drift_.gradient[0] * cell.height()));
  }
  /// Whether the deviations must be measured after this step.
  bool measures() const { return measures_; }
  /// Smallest remaining allowance of the grains of the range, m.
  double measure(SlackPass<Real> slack, const MovingGrains<Real>& grains) const {
    return slack(drift_, start_.data(), grains);
  }
  /// Accounts for one step. Returns whether the list must be built anew. `largest_growth` (m) bounds the growth of a
  /// deviation in this step. `measured` (m) is the smallest remaining allowance over all ranges, used only if
  /// `measures()` was true. `reach` (m) is the largest distance of two centres in the list. `compressed` is true if the
  /// periods moved grains, which the measurement does not include.
  bool advance(double largest_growth, double measured, double reach, bool compressed);
  /// Number of steps since the start.
  std::int64_t age() const { return age_; }

 private:
  std::vector<Start> start_;  ///< of all grains; only those of the range are used
  MeanDrift drift_;
  double slack_ = 0.0;  ///< lower bound of the smallest remaining allowance, m
  bool compressed_ = false, measures_ = false;
  std::int64_t age_ = 0;
};

}  // namespace flowslide::native
