// SPDX-License-Identifier: GPL-2.0-or-later
// What all cases that slide share. A case derives from SlideCase and adds the numbers that its claims are about; the
// rest stands in its case.toml: the slides as [point.<name>] (see read_slide_point), as many replicates of each as
// `replicates` says (at most [point.<name>] `replicates` of them), every one on a sample of its own and a point of its
// own, so that they run side by side and are kept one by one. Element tests of the samples alone may stand beside
// them; on a closed-form sample these are left out, and on LIGGGHTS the points on samples that are periodic along z.
#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "experiment/ensemble.hpp"
#include "program/slide_point.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

/// What came out of one slide, or of an element test beside it.
struct SlideOutcome {
  const SlidePoint& point;
  const Series& series;         ///< rows that were kept (see slide_series), or of a test those that were measured
  const RunMeasures& measures;  ///< gathered at every exchange
  const Series& profiles;   ///< see ProfileRecord; without columns if none were asked for
  Stop stop;                ///< why it ended
  const DemSample* grains = nullptr;  ///< the sample as it is left; null if it is not made of grains
};

class SlideCase : public Case {
 public:
  /// Without engines in its description, the case takes all engines and closed-form samples.
  explicit SlideCase(CaseDescription description);

  CaseDescription description() const override { return description_; }
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  /// The bands of each slide: see finish().
  std::vector<std::string> tables() const override;
  void print_plan(const Point& point, std::ostream& out) const override;
  void prepare(const Point& point, const ProgressStyle& progress, const PreparationBorder& border) const override;
  /// Writes <point>.h5 and .dat, and <point>_profiles.dat if profiles were asked for; without metrics, if computing
  /// them fails. The end of the run is kept as a checkpoint before.
  void run(const Point& point, const PointRun& run) const override;
  /// "<point>.<metric>" of each result, "<slide>.<metric>.median" and so on of its replicates (see summary_of), and
  /// what compare() adds.
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  /// Median and band of the replicates of each slide: <slide>_over_<abscissa>.dat and <slide>_profiles_band.dat. What a
  /// closed-form sample has not (profiles, element tests) is written as a table without rows.
  void finish(const OutputFolder& output) const override;

 protected:
  /// The numbers of one slide (or test), whatever its loading; those that are not finite are left out.
  virtual std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const = 0;
  /// Numbers about several slides, from those of the case that have been run. `metrics` holds all others already.
  virtual void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const = 0;
  /// Columns, or the axis "time", over which the figures show the replicates.
  virtual std::vector<std::string> abscissas() const = 0;
  /// Time between two measurements of the mean stress, s, for metrics of the inertial number (see ExchangeRecord).
  virtual double mean_stress_interval() const { return std::numeric_limits<double>::infinity(); }
  /// Strains of an element test, rising, at which its whole sample is kept for pictures.
  virtual std::vector<double> picture_strains(const SlidePoint&) const { return {}; }
  /// Writes pictures of the sample at these strains; a folder of them is named <point>_frames.
  virtual void write_pictures(const OutputFolder&, const SlidePoint&, const std::vector<Shot>&) const {}
  /// Parameters of a slide beside those of SlidePoint.
  virtual std::vector<Metric> more_parameters(const SlidePoint&) const { return {}; }

  const SlopeProperties& slope() const { return slope_; }
  /// All slides of the configuration, replicates too.
  const std::vector<SlidePoint>& slides() const { return slides_; }
  /// Their names without the replicates, and those of element tests that a closed-form sample does not have.
  std::vector<std::string> slide_names() const;
  /// The results of these points by the names of their slides.
  Ensembles results_in(const std::filesystem::path& folder, const std::vector<std::string>& points) const;
  /// Whether these are slides; else element tests, which have no displacement.
  static bool are_slides(const Ensemble& ensemble) { return ensemble.front().series.has("displacement"); }
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
  /// What is written of records, complete or not: without the metrics of the case, which judge() adds.
  Result result_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run, const Records& records) const;
  /// The same with them; without, if they cannot be computed of a record that is not complete.
  Result judged(const SlidePoint& running, const Loaded& loaded, const PointRun& run, const Records& records) const;
  void write_empty_tables(const OutputFolder& output) const;
  void judge(Result& result, const SlidePoint& running, const Loaded& loaded, const Records& records) const;
  Provenance provenance_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run) const;

  CaseDescription description_;
  std::string preparation_engine_;
  std::function<std::unique_ptr<Sample>()> closed_form_;  ///< in place of an engine
  std::int64_t seed_ = 1;
  SlopeProperties slope_;
  std::vector<SlidePoint> slides_;
  std::vector<SlidePoint> left_out_;  ///< first replicates of what the engine or the closed-form sample cannot run
};

}  // namespace flowslide
