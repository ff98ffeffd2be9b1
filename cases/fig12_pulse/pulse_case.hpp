// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 11 and 12: a slope that is triggered by a sine pulse of the driving stress, with RD and with RI, for several
/// amplitudes.
class PulseCase : public SlideCase {
 public:
  PulseCase();
  /// Also writes the amplitude of each slide as the legend, and <slide>_windows.dat, the replicates over x in wider
  /// windows. The wider windows are for the pore pressure, which jumps whenever the grains jam.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
};

}  // namespace flowslide
