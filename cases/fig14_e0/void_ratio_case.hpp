// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "app/slide_case.hpp"

namespace flowslide {

/// Fig. 14: runout after a sine pulse of the driving stress, by RD and by RI, of samples of four void ratios. Slides
/// are named "<scheme>_e0_<the paper's void ratio in thousandths>", such as "RI_e0_771".
class VoidRatioCase : public SlideCase {
 public:
  VoidRatioCase();
  /// And <slide>_coarse.dat, see coarse_band, and sweep.dat: void ratios, velocity and runout over the
  /// paper's void ratio.
  void finish(const OutputFolder& output) const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
};

}  // namespace flowslide
