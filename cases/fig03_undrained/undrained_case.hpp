// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <map>
#include <string>

#include "program/slide_case.hpp"

namespace flowslide {

/// Figs. 2, 3 and 4: constant-volume simple shear of loose packings. The points are element tests. A point with the key
/// `picture_strain` also writes the pictures of Fig. 2: the sample before shear and at this strain.
class UndrainedCase : public SlideCase {
 public:
  UndrainedCase();
  void read(const Configuration& configuration) override;
  std::vector<std::string> tables() const override;
  /// Also writes the legend, and the metrics of all curves as curves.dat (see curves_table).
  void finish(const OutputFolder& output) const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const override;
  std::vector<std::string> abscissas() const override { return {}; }
  std::vector<double> picture_strains(const SlidePoint& point) const override;
  void write_pictures(const OutputFolder& output, const SlidePoint& point,
                      const std::vector<Shot>& shots) const override;

 private:
  std::map<std::string, double> picture_strains_;  ///< name of the table of a point -> its picture_strain
};

}  // namespace flowslide
