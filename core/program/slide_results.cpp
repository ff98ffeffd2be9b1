// SPDX-License-Identifier: GPL-2.0-or-later
// The part of SlideCase that reads results: metrics, and the tables of the figures.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "program/replicates.hpp"
#include "program/slide_case.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr int band_rows = 200;  ///< rows of a band; more than a figure can resolve

Table band_table(const std::string& case_name, const std::string& slide, std::size_t replicates, Series series) {
  return {{{"case", case_name}, {"slide", slide}, {"replicates", fmt::format("{}", replicates)}}, std::move(series)};
}

/// Some samples of a slide stop early, or bear the load, and others slide on. Over distance and strain a band ends with
/// most of them.
BandEnd end_over(const std::string& abscissa) { return abscissa == "time" ? BandEnd::all : BandEnd::most; }

}  // namespace

std::vector<std::string> SlideCase::slide_names() const {
  std::vector<std::string> names;
  for (const SlidePoint& slide : left_out_) names.push_back(slide.name);
  for (const SlidePoint& slide : slides_)
    if (slide.replicate == 0) names.push_back(slide.name);
  return names;
}

std::vector<std::string> SlideCase::tables() const {
  std::vector<std::string> tables;
  for (const std::string& name : slide_names()) {
    for (const std::string& abscissa : abscissas()) tables.push_back(fmt::format("{}_over_{}", name, abscissa));
    tables.push_back(name + "_profiles_band");
  }
  return tables;
}

Ensembles SlideCase::results_in(const std::filesystem::path& folder, const std::vector<std::string>& points) const {
  Ensembles slides;
  std::vector<Provenance> origins;
  for (const std::string& point : points) {
    Ensemble& replicates = slides[slide(point).name];
    replicates.push_back(read_result(folder / (point + ".h5")));
    origins.push_back(replicates.back().provenance);
  }
  refuse_equal_samples(origins);
  return slides;
}

std::map<std::string, double> SlideCase::metrics(const std::filesystem::path& folder,
                                                 const std::vector<std::string>& points) const {
  Ensembles slides = results_in(folder, points);
  std::map<std::string, double> all;
  for (const auto& [name, ensemble] : slides) {
    for (const auto& [metric, value] : summary_of(ensemble)) all[fmt::format("{}.{}", name, metric)] = value;
    for (const Result& result : ensemble)
      for (const Metric& metric : result.metrics)
        all[fmt::format("{}.{}", result.provenance.point, metric.name)] = metric.value;
  }
  for (const SlidePoint& slide : slides_)
    if (!slide.published) slides.erase(slide.name);
  compare(slides, all);
  std::erase_if(all, [](const auto& metric) { return !std::isfinite(metric.second); });
  return all;
}

std::vector<std::string> SlideCase::points_in(const OutputFolder& output) const {
  std::vector<std::string> present;
  for (const SlidePoint& slide : slides_)
    if (output.has_result(slide.point.name)) present.push_back(slide.point.name);
  return present;
}

void SlideCase::finish(const OutputFolder& output) const {
  const std::vector<std::string> present = points_in(output);
  std::map<std::string, std::vector<Series>> profiles;
  for (const std::string& point : present) {
    const auto file = output.file(point + "_profiles.dat");
    if (std::filesystem::exists(file)) profiles[slide(point).name].push_back(read_table(file).series);
  }
  for (const auto& [name, ensemble] : results_in(output.path(), present))
    for (const std::string& abscissa : abscissas())
      if (ensemble.front().series.has(abscissa))
        write_table(output.file(fmt::format("{}_over_{}.dat", name, abscissa)),
                    band_table(description_.name, name, ensemble.size(),
                               band_over(ensemble, abscissa, band_rows, end_over(abscissa))));
  for (const auto& [name, all] : profiles)
    write_table(output.file(name + "_profiles_band.dat"),
                band_table(description_.name, name, all.size(), band_of_rows(all)));
  write_empty_tables(output);
}

void SlideCase::write_empty_tables(const OutputFolder& output) const {
  for (const SlidePoint& slide : left_out_) {
    const std::string& name = slide.name;
    Result none;
    none.series = slide.test ? shear_test_series() : slide_series();
    write_table(output.file(name + ".dat"), band_table(description_.name, name, 0, none.series));
    for (const std::string& abscissa : abscissas())
      if (none.series.has(abscissa))
        write_table(output.file(fmt::format("{}_over_{}.dat", name, abscissa)),
                    band_table(description_.name, name, 0, band_over({none}, abscissa, band_rows)));
  }
  for (const SlidePoint& slide : slides_)
    if (slide.closed_form && slide.replicate == 0 && !slide.profiles.strains.empty())
      write_table(output.file(slide.name + "_profiles_band.dat"),
                  band_table(description_.name, slide.name, 0, band_of_rows({ProfileRecord(slide.profiles).series()})));
}

}  // namespace flowslide
