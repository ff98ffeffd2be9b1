// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// The map of jamming: constant-volume shear of samples of several void ratios at several rates, with and without
/// torsion resistance. And the open choices one at a time: shear and slides of two samples of the paper.
class OpenChoicesCase : public SlideCase {
 public:
  OpenChoicesCase();
  /// Also writes map.dat, a row for each run of the map, and choices.md (see choices_table).
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles&, std::map<std::string, double>&) const override {}
  std::vector<std::string> abscissas() const override { return {"shear_strain"}; }
};

}  // namespace flowslide
