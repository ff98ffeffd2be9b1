// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 8, 9 and 10: a slope that is loaded at a constant rate until it liquefies, with RD and with RI.
class TriggerCase : public SlideCase {
 public:
  TriggerCase();
  /// Also writes <slide>_friction_band.dat and steady_friction.dat for Fig. 9B, peaks.dat for the marks in Fig. 8, and
  /// the legend of Fig. 10.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"time", "shear_strain"}; }
  double mean_stress_interval() const override { return 5e-4; }
};

}  // namespace flowslide
