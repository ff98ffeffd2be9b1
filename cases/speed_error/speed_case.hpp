// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "report.hpp"

namespace flowslide {

/// Speed against error: what each choice costs, and what it buys, on three scenes. Every setting is a slide or an
/// element test of SlideCase. [axis.<name>] (title, reference, settings; competes if there) says which are compared;
/// from [liggghts] (grains, local_time_step, shear_rate of the element test, and for each scene the setting that times
/// it) follows what LIGGGHTS takes at the paper's settings.
class SpeedCase : public SlideCase {
 public:
  SpeedCase();
  void read(const Configuration& configuration) override;
  /// Adds the report (see write_report), and prints the table on stderr.
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override { return scene_metrics(outcome); }
  /// "<axis>.<setting>.<quantity>.error" (relative) and ".error_over_spread"; "<axis>.<setting>.error_over_spread", the
  /// largest of its quantities; "<axis>.largest_error_over_spread"; "<axis>.<setting>.steps_share", its steps over those
  /// of the reference.
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {}; }

 private:
  Report report_on(const Ensembles& runs) const;
  /// The slide or test of that name; null if this run has none.
  const SlidePoint* planned(const std::string& setting) const;
  /// The one that `key` names.
  const SlidePoint* find(const Configuration& configuration, const std::string& key) const;
  void read_axis(const Configuration& configuration, const std::string& name);

  std::vector<Axis> axes_;
  double paper_grains_ = 0.0, paper_time_step_ = 0.0, paper_rate_ = 0.0;
  std::map<Scene, std::string> clocks_;  ///< the settings that time LIGGGHTS
};

}  // namespace flowslide
