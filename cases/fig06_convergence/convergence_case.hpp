// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 6 and 7: a slope on a sample that is sheared at a given inertial number, for several time steps dt_G and
/// several rules to pass the strain. Element tests of the sample at the same rate are the reference.
class ConvergenceCase : public SlideCase {
 public:
  ConvergenceCase();

  /// Also writes the errors to table.md, and dt_G of each slide as the legend.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"shear_strain"}; }
};

}  // namespace flowslide
