// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/case.hpp"
#include "scenes.hpp"

namespace flowslide {

/// Scenes that are hard for codes of this kind, each compared with theory or with a refined run. A scene is one point.
class HardCase : public Case {
 public:
  CaseDescription description() const override;
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  std::vector<std::string> tables() const override { return {"trials"}; }
  void print_plan(const Point& point, std::ostream& out) const override;
  /// Writes <scene>.h5 and <scene>.dat, the trials as rows of a Markdown table in <scene>.md, and <scene>_details.dat
  /// if the scene has such a table.
  void run(const Point& point, const PointRun& run) const override;
  /// Number of trials by outcome: "<scene>.accurate", ".stable", ".refused", ".silently_wrong", ".needlessly_refused",
  /// and ".failures", the sum of the last two. Also the metrics of the scene itself.
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  /// Writes table.md with one line per scene, and trials.md with one line per trial.
  void finish(const OutputFolder& output) const override;

 private:
  const Scene& scene(const std::string& name) const;

  SceneSettings settings_;
  std::vector<Scene> scenes_;
};

}  // namespace flowslide
