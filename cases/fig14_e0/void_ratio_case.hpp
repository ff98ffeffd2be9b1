// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "program/slide_case.hpp"

namespace flowslide {

/// Fig. 14: runout after a sine pulse of the driving stress, by RD and by RI, of samples of four void ratios. Slides
/// are named "<scheme>_e0_...", such as "RI_e0_771". The void ratio that a sample has in the paper stands in its table
/// as `paper_void_ratio`, and in the results as a parameter; a sample without that key has its own void ratio there.
class VoidRatioCase : public SlideCase {
 public:
  VoidRatioCase();
  void read(const Configuration& configuration) override;
  /// And <slide>_coarse.dat, see coarse_band, and sweep.dat: void ratios, velocity and runout over the
  /// paper's void ratio; and the legend, that void ratio of each slide.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
  std::vector<Metric> more_parameters(const SlidePoint& point) const override;

 private:
  std::map<std::string, double> paper_void_ratios_;  ///< by the name of the sample
};

}  // namespace flowslide
