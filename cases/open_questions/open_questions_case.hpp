// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"

namespace flowslide {

/// Questions that the paper could not answer or left open. Slides and element tests run on samples with glued layers
/// and on homogeneous samples. A homogeneous sample is sheared across the periodic faces of its cell (Lees and Edwards
/// 1972).
///   hold_<sample>    a slope loaded at a constant rate and then held: velocity profile, steady friction
///   pulse_<sample>   the same slope after a pulse: largest velocity, also on samples of other sizes
///   flow_<...>       constant-volume shear of homogeneous samples at several rates: mu(I)
///   probe_<sample>   shear to a strain of 1e-5: shear modulus, and the natural frequencies computed from it
class OpenQuestionsCase : public SlideCase {
 public:
  OpenQuestionsCase();
  /// Also writes mu_of_I_<density>.dat, mu_of_I_laws.dat, sizes_<sample>.dat, and all answers as table.md.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {"shear_strain"}; }
};

}  // namespace flowslide
