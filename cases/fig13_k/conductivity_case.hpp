// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Fig. 13: runout after a sine pulse of the driving stress, with RD and with RI, for several hydraulic conductivities.
/// Slides are named "<scheme>_...", such as "RI_4e-5". k is their parameter hydraulic_conductivity.
class ConductivityCase : public SlideCase {
 public:
  ConductivityCase();
  /// Also writes <slide>_coarse.dat (see coarse_band), sweep.dat (velocity and runout over k), critical.dat (see
  /// critical_series), and k of each slide as the legend.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
};

}  // namespace flowslide
