// SPDX-License-Identifier: GPL-2.0-or-later
// The common part of all cases with slides. A case derives from SlideCase and adds the metrics for its claims. Its
// case.toml gives the slides as [point.<name>] (see read_slide_point) and their number of replicates, `replicates`. The
// key `replicates` of [point.<name>] limits this number for one slide. Each replicate has a sample of its own and is a
// run of its own, so replicates can run side by side. A point may also be an element test of a sample alone. Element
// tests are left out on a closed-form sample; with LIGGGHTS, points on samples that are periodic along z are left out.
#pragma once
#include <limits>
#include <memory>
#include <optional>

#include "experiment/ensemble.hpp"
#include "program/slide_point.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

/// The outcome of one slide or element test, for its metrics.
struct SlideOutcome {
  const SlidePoint& point;
  const Series& series;         ///< rows kept (see slide_series); for an element test the measured rows
  const RunMeasures& measures;  ///< gathered at every exchange
  const Series& profiles;   ///< see ProfileRecord; without columns if the run takes no profiles
  Stop stop;                ///< the condition that ended the run
  const DemSample* grains = nullptr;  ///< the sample in its last state; null for a closed-form sample
};

class SlideCase : public Case {
 public:
  /// If `description` names no engines, the case accepts all engines and all closed-form samples.
  explicit SlideCase(CaseDescription description);

  CaseDescription description() const override { return description_; }
  /// Adds the points of `configuration`. A case may call it again with variants of its configuration.
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  /// Names of the band tables of each slide: see finish().
  std::vector<std::string> tables() const override;
  void print_plan(const Point& point, std::ostream& out) const override;
  void prepare(const Point& point, int threads, const ProgressStyle& progress,
               const PreparationPoll& poll) const override;
  /// Runs the point, stores its last state as a checkpoint, and writes <point>.dat, <point>_profiles.dat (if the run
  /// takes profiles) and <point>.h5. If computing the metrics fails, writes the files without them and throws.
  void run(const Point& point, const PointRun& run) const override;
  /// "<point>.<metric>" for each result, "<slide>.<metric>.median" and so on for the replicates (see summary_of), and
  /// the metrics that compare() adds.
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  /// Writes median and band of the replicates of each slide: <slide>_over_<abscissa>.dat and <slide>_profiles_band.dat.
  /// The tables of points that were left out (see above), and of profiles on a closed-form sample, have no rows.
  void finish(const OutputFolder& output) const override;

  /// Whether the results are of slides. Element tests have no displacement.
  static bool are_slides(const Ensemble& ensemble) { return ensemble.front().series.has("displacement"); }

 protected:
  /// The metrics of one slide or element test. The caller leaves out metrics that are not finite.
  virtual std::vector<Metric> slide_metrics(const SlideOutcome& outcome) const = 0;
  /// Adds metrics about several slides to `metrics`, which has all other metrics. `slides` are the slides of the case
  /// that have results, without those that the user added.
  virtual void compare(const Ensembles& slides, std::map<std::string, double>& metrics) const = 0;
  /// Columns, or the axis "time", over which the figures show the replicates.
  virtual std::vector<std::string> abscissas() const = 0;
  /// Time between two measurements of the mean stress, s, for metrics of the inertial number (see ExchangeRecord).
  virtual double mean_stress_interval() const { return std::numeric_limits<double>::infinity(); }
  /// Increasing strains of an element test at which the whole sample is stored for pictures.
  virtual std::vector<double> picture_strains(const SlidePoint&) const { return {}; }
  /// Writes pictures of the sample at these strains. A folder of pictures must have the name <point>_frames.
  virtual void write_pictures(const OutputFolder&, const SlidePoint&, const std::vector<Shot>&) const {}
  /// Parameters of a slide beside those of SlidePoint.
  virtual std::vector<Metric> more_parameters(const SlidePoint&) const { return {}; }

  const SlopeProperties& slope() const { return slope_; }
  /// All points of the configuration that this engine can run, with their replicates.
  const std::vector<SlidePoint>& slides() const { return slides_; }
  /// Names of all points, without the numbers of replicates. Includes the points that were left out.
  std::vector<std::string> slide_names() const;
  /// The results of these points, grouped by slide.
  Ensembles results_in(const std::filesystem::path& folder, const std::vector<std::string>& points) const;
  /// The points that have results in `output`.
  std::vector<std::string> points_in(const OutputFolder& output) const;

 private:
  struct Loaded;
  struct Records;
  const SlidePoint& slide(const std::string& point) const;
  /// Finds the sample of a point, and adapts the point to this sample (see on_sample).
  Loaded load(SlidePoint& slide, const PointRun& run) const;
  Records shear(const SlidePoint& running, Loaded& loaded, const PointRun& run) const;
  Records slide_on(const SlidePoint& running, Loaded& loaded, const PointRun& run) const;
  /// The result for these records, complete or not, without the metrics of the case.
  Result result_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run, const Records& records) const;
  /// The result with the metrics of the case. If they cannot be computed, for instance from incomplete records, the
  /// result has only the metrics of the sample.
  Result judged(const SlidePoint& running, const Loaded& loaded, const PointRun& run, const Records& records) const;
  void write_empty_tables(const OutputFolder& output) const;
  /// Adds the metrics of the case to a result.
  void judge(Result& result, const SlidePoint& running, const Loaded& loaded, const Records& records) const;
  Provenance provenance_of(const SlidePoint& running, const Loaded& loaded, const PointRun& run) const;

  CaseDescription description_;
  std::string preparation_engine_;
  std::int64_t seed_ = 1;
  SlopeProperties slope_;
  std::vector<SlidePoint> slides_;
  std::vector<SlidePoint> left_out_;  ///< first replicate of each point that the engine cannot run
};

}  // namespace flowslide
