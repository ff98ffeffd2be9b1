// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <optional>

#include "experiment/shear_test.hpp"
#include "pictures.hpp"
#include "program/case.hpp"
#include "record/result_file.hpp"
#include "sample/specification.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

/// One curve of Fig. 3 or 4.
struct Curve {
  Point point;                             ///< named after the curve and the replicate
  std::string name;                        ///< of its table [point.<name>]
  ShearTest test;
  double time_step = 0.0;                  ///< dt_L, s
  std::size_t sample = 0;                  ///< index into samples of its replicate
  int replicate = 0;
  std::optional<double> picture_strain;    ///< of Fig. 2B; a curve with one also writes ParaView files
};

/// Figs. 2, 3 and 4: constant-volume simple shear of loose packings.
class UndrainedCase : public Case {
 public:
  CaseDescription description() const override;
  void read(const Configuration& configuration) override;
  std::vector<Point> points() const override;
  std::vector<std::string> tables() const override { return {"legend", "curves", "fig02_before", "fig02_during"}; }
  void print_plan(const Point& point, std::ostream& out) const override;
  void prepare(const Point& point, const ProgressStyle& progress, const PreparationBorder& border) const override;
  void run(const Point& point, const PointRun& run) const override;
  std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                        const std::vector<std::string>& points) const override;
  void finish(const OutputFolder& output) const override;

 private:
  void read_curve(const Configuration& configuration, const std::string& name, int replicate);
  const Curve& curve(const std::string& name) const;
  /// The sample of a curve, from the cache or by the engine of the preparation, which writes of itself to `log`.
  FoundSample sample_for(const Curve& curve, const std::filesystem::path& log, const ProgressStyle& progress,
                         int threads, const PreparationBorder& border) const;
  std::vector<Metric> parameters_of(const Curve& curve) const;
  ShearTestRecord shear(const Curve& running, const FoundSample& found, DemSample& sample,
                          Pictures& pictures, const PointRun& run) const;
  /// What is written of a record, complete or not: without the metrics of the curve, which judge() adds.
  Result result_of(const Curve& running, const FoundSample& found, const PointRun& run,
                   const ShearTestRecord& record) const;
  void judge(Result& result, const Curve& running, const ShearTestRecord& record) const;
  const SampleSpecification& sample_of(const Curve& curve) const { return samples_[curve.replicate][curve.sample]; }

  std::string engine_, preparation_engine_;
  std::int64_t seed_ = 1;
  SlopeProperties slope_;
  std::vector<std::vector<SampleSpecification>> samples_;  ///< per replicate
  std::vector<Curve> curves_;
};

}  // namespace flowslide
