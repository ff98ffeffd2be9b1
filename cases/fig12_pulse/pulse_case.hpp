// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 11 and 12: a slope that is triggered by a sine pulse of the driving stress, with RD and with RI, for several
/// amplitudes.
class PulseCase : public SlideCase {
 public:
  PulseCase();
  /// Also writes <slide>_windows.dat, the replicates over x in wider windows, for the pore pressure: it jumps whenever
  /// the grains jam. Writes the amplitude of each slide as the legend.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
};

}  // namespace flowslide
