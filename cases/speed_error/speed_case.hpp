// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "report.hpp"

namespace flowslide {

/// Speed against error: cost and error of each choice in three scenes. Every setting is a slide or an element test of
/// SlideCase.
///   [axis.<name>]  title, reference, settings, competes (optional): the settings that are compared
///   [liggghts]     grains, local_time_step and shear_rate (of the element test) of the paper, and for each scene the
///                  setting whose run measures the speed of LIGGGHTS; they give the cost at the settings of the paper
class SpeedCase : public SlideCase {
 public:
  SpeedCase();
  void read(const Configuration& configuration) override;
  /// Also writes the report (see write_report) and prints its tables on stderr.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override { return scene_metrics(outcome); }
  /// Adds these metrics:
  ///   <axis>.<setting>.<quantity>.error, ...error_over_spread   see QuantityError
  ///   <axis>.<setting>.error_over_spread                        largest value of its quantities
  ///   <axis>.largest_error_over_spread                          largest value of its settings
  ///   <axis>.<setting>.steps_share                              DEM steps / DEM steps of the reference
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {}; }

 private:
  Report report_on(const Ensembles& runs) const;
  /// The slide or test with this name; null if there is none.
  const SlidePoint* planned(const std::string& setting) const;
  /// The slide or test whose name is the value of `key`; null if it was left out (see SlideCase).
  const SlidePoint* find(const Configuration& configuration, const std::string& key) const;
  void read_axis(const Configuration& configuration, const std::string& name);

  std::vector<Axis> axes_;
  double paper_grains_ = 0.0, paper_time_step_ = 0.0, paper_rate_ = 0.0;
  std::map<Scene, std::string> clocks_;  ///< the settings whose runs measure the speed of LIGGGHTS
};

}  // namespace flowslide
