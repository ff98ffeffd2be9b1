// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "program/slide_case.hpp"

namespace flowslide {

/// Fig. 14: runout after a sine pulse of the driving stress, with RD and with RI, for samples of four void ratios.
/// Slides are named "<scheme>_e0_...", such as "RI_e0_771". The key `paper_void_ratio` of [sample.<name>] gives the
/// void ratio of this sample in the paper; without this key it is the void ratio of the sample. Results have it as a
/// parameter.
class VoidRatioCase : public SlideCase {
 public:
  VoidRatioCase();
  void read(const Configuration& configuration) override;
  /// Also writes <slide>_coarse.dat (see coarse_band), sweep.dat (void ratios, velocity and runout over the void ratio
  /// of the paper), and the void ratio of the paper for each slide as the legend.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
  std::vector<Metric> more_parameters(const SlidePoint& point) const override;

 private:
  std::map<std::string, double> paper_void_ratios_;  ///< name of the sample -> void ratio in the paper
};

}  // namespace flowslide
