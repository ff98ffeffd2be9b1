// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 6 and 7: a slope on a sample sheared at a given inertial number, by several time steps dt_G and ways to pass
/// the strain on, beside the sample alone at the same rate.
class ConvergenceCase : public SlideCase {
 public:
  ConvergenceCase();

  /// The errors as table.md besides, and the legend, dt_G of each slide.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"shear_strain"}; }
};

}  // namespace flowslide
