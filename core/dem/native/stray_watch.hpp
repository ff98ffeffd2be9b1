// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "dem/native/passes.hpp"
#include "dem/native/share.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// How long a list holds of all pairs nearer than touching plus the allowances of both grains: as long as none has
/// strayed from the mean flow by more than its allowance. The ways are bounded step by step and measured only when the
/// bound is used up. Every worker watches its own grains and hears of the others'; all come to the same answer.
template <typename Real>
class StrayWatch {
 public:
  /// Starts anew where the grains of the share are now; `allowance` of all grains, m.
  void start(const Share& share, const std::vector<Body<double>>& bodies, const std::vector<double>& allowance);
  /// The boundaries' field carries the grains on by a step of `time_step`, s.
  void follow(const MeanFlow& flow, double time_step) { drift_.add(flow, time_step); }
  /// A grain was carried by `way`, m, along an axis, by no motion of its own.
  void carry(std::size_t grain, int axis, double way) { start_[grain].position[axis] += way; }
  /// A grain was folded by so many heights of a sheared cell, and along x with them: as far as its image was away at the
  /// start, from where on the mean flow drifts as that of the other layer.
  void cross_the_shear(std::size_t grain, int layers, const Cell& cell) {
    carry(grain, 0, layers * (cell.shear_offset - drift_.gradient[0] * cell.height()));
  }
  /// Whether the ways are to be measured after this step.
  bool measures() const { return measures_; }
  /// Least allowance that is left to the share's grains, m.
  double measure(SlackPass<Real> slack, const MovingGrains<Real>& grains) const {
    return slack(drift_, start_.data(), grains);
  }
  /// A step in which no way grew by more than `pace`, m; `measured`: the least over all shares, if it was asked for;
  /// `reach`: largest distance of two centres in the list, m; `compressed`: grains were carried sidewards, which is not
  /// measured. Returns whether the list must be made anew.
  bool spend(double pace, double measured, double reach, bool compressed);
  /// Steps since the start.
  std::int64_t age() const { return age_; }

 private:
  std::vector<Start> start_;  ///< of all grains; only those of the share count
  MeanDrift drift_;
  double slack_ = 0.0;  ///< lower bound of the least allowance that is left, m
  bool compressed_ = false, measures_ = false;
  std::int64_t age_ = 0;
};

}  // namespace flowslide::native
