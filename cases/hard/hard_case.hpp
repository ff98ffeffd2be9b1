// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/case.hpp"
#include "scenes.hpp"

namespace flowslide {

/// Scenes that break codes of this kind, one point each, judged against theory or a refined run.
class HardCase : public Case {
 public:
  CaseDescription description() const override;
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  std::vector<std::string> tables() const override { return {"trials"}; }
  void print_plan(const Point& point, std::ostream& out) const override;
  /// Writes <scene>.h5 and .dat, its trials as lines of Markdown in <scene>.md, and <scene>_details.dat if it has any.
  void run(const Point& point, const PointRun& run) const override;
  /// "<scene>.accurate", ".stable", ".refused", ".silently_wrong", ".needlessly_refused", ".failures" (the last two
  /// together), and what a scene adds.
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  /// table.md, one line per scene, and trials.md, one line per trial.
  void finish(const OutputFolder& output) const override;

 private:
  const Scene& scene(const std::string& name) const;

  Suite suite_;
  std::vector<Scene> scenes_;
};

}  // namespace flowslide
