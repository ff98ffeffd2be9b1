// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "program/slide_case.hpp"
#include "study_run.hpp"
#include "sweep.hpp"

namespace flowslide {

/// A study of the user's own, without claims: one slope, sample and loading by one or several schemes, single or over a
/// sweep (see read_sweep). Its configuration has no points. The runs are made of these keys:
///   study.sample   name of the sample
///   study.scheme   one or several names of schemes
///   sweep.<key>    the values of the swept key; optional
/// A run is named <scheme>, or <scheme>_<value> in a sweep. It has the configuration of the study with its own value.
/// A value, a scheme or a replicate that is added later leaves the results of the other runs valid.
class StudyCase : public SlideCase {
 public:
  StudyCase();
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  /// Also writes the tables of write_study_tables, and <run>_coarse.dat (see coarse_band).
  void finish(const OutputFolder& output) const override;
  std::vector<std::string> tables() const override;

 protected:
  std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const override;
  void compare(const Ensembles&, std::map<std::string, double>&) const override {}
  std::vector<std::string> abscissas() const override { return {"displacement", "time"}; }
  /// The swept value as "swept_<key>", if it is a number.
  std::vector<Metric> more_parameters(const SlidePoint& point) const override;

 private:
  /// Reads the run of a scheme, with one value of the sweep. Null: there is no sweep.
  void read_run(const Configuration& configuration, std::size_t scheme, const SweepValue* value);
  const StudyRun& run_named(const std::string& name) const;

  std::string engine_, sample_;
  std::vector<std::string> schemes_;
  Sweep sweep_;
  std::vector<StudyRun> runs_;
};

}  // namespace flowslide
