// SPDX-License-Identifier: GPL-2.0-or-later
// What all cases that slide share. A case derives from SlideCase and adds the numbers that its claims are about; the
// rest stands in its case.toml: the slides as [point.<name>] (see read_slide_point), as many replicates of each as
// `replicates` says (at most [point.<name>] `replicates` of them), every one on a sample of its own and a point of its
// own, so that they run side by side and are kept one by one. Element tests of the samples alone may stand beside
// them; on a closed-form sample these are left out.
#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "app/ensemble.hpp"
#include "app/sample_cache.hpp"
#include "app/slide_point.hpp"

namespace flowslide {

/// What came out of one slide, or of an element test beside it.
struct SlideOutcome {
  const SlidePoint& point;
  const Series& series;     ///< see slide_series, or element_test_series
  const Series& profiles;   ///< see ProfileRecord; without columns if none were asked for
  Stop stop;                ///< why it ended
  const DemSample* grains = nullptr;  ///< the sample as it is left; null if it is not made of grains
};

class SlideCase : public Case {
 public:
  explicit SlideCase(CaseDescription description);

  CaseDescription description() const override { return description_; }
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  void print_plan(const Point& point, std::ostream& out) const override;
  void prepare(const Point& point, const ProgressStyle& progress, const PreparationBorder& border) const override;
  /// Writes <point>.h5 and .dat, and <point>_profiles.dat if profiles were asked for.
  void run(const Point& point, const PointRun& run) const override;
  /// "<point>.<metric>" of each result, "<slide>.<metric>.median" and so on of its replicates (see summary_of), and
  /// what compare() adds.
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  /// Median and band of the replicates of each slide: <slide>_over_<abscissa>.dat and <slide>_profiles_band.dat.
  void finish(const OutputFolder& output) const override;

 protected:
  /// The numbers of one slide (or test); those that are not finite are left out.
  virtual std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const = 0;
  /// Numbers about several slides, from those that have been run. `metrics` holds all others already.
  virtual void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const = 0;
  /// Columns, or the axis "time", over which the figures show the replicates.
  virtual std::vector<std::string> abscissas() const = 0;

  const SlopeProperties& slope() const { return slope_; }
  /// All slides of the configuration, replicates too.
  const std::vector<SlidePoint>& slides() const { return slides_; }
  /// The results of these points by the names of their slides.
  Ensembles results_in(const std::filesystem::path& folder, const std::vector<std::string>& points) const;
  /// The points whose results are there.
  std::vector<std::string> points_in(const OutputFolder& output) const;

 private:
  struct Loaded;
  struct Records;
  const SlidePoint& slide(const std::string& point) const;
  /// Finds the sample of a point, and makes the point one on that sample (see on_sample).
  Loaded load(SlidePoint& slide, const PointRun& run) const;
  Records shear(const SlidePoint& running, Loaded& loaded, const PointRun& run) const;
  Records slide_on(const SlidePoint& running, Loaded& loaded, const PointRun& run) const;
  /// What is written of records, complete or not.
  Result result_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run, const Records& records) const;

  CaseDescription description_;
  std::string preparation_engine_;
  std::function<std::unique_ptr<Sample>()> closed_form_;  ///< in place of an engine
  std::int64_t seed_ = 1;
  SlopeProperties slope_;
  std::vector<SlidePoint> slides_;
};

}  // namespace flowslide
