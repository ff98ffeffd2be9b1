// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// What the paper could not do or left open. Slides and element tests of SlideCase, on samples with glued layers and on
/// samples that are sheared homogeneously, across the periodic faces of their cell (Lees and Edwards 1972):
///   hold_<sample>    a slope loaded at a constant rate and then held: profile of the velocity, steady friction
///   pulse_<sample>   the same slope after a pulse: the largest velocity, also on samples of other sizes
///   flow_<...>       constant-volume shear of homogeneous samples at several rates: mu(I)
///   probe_<sample>   the first 1e-4 of strain: the shear modulus, and the natural frequencies that follow from it
class OpenQuestionsCase : public SlideCase {
 public:
  OpenQuestionsCase();
  /// Adds mu_of_I_<density>.dat and mu_of_I_laws.dat, sizes_<sample>.dat, and all answers in table.md.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"shear_strain"}; }
};

}  // namespace flowslide
