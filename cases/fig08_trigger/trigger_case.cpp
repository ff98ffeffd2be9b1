// SPDX-License-Identifier: GPL-2.0-or-later
#include "trigger_case.hpp"

#include <fmt/format.h>

#include <cmath>

#include "comparison.hpp"
#include "marked_states.hpp"
#include "profile_metrics.hpp"
#include "record/gnuplot_table.hpp"
#include "run/legend.hpp"
#include "trigger_metrics.hpp"

namespace flowslide {

namespace {

std::string steady_head() {
  return table_head({{"slide", "", "text", "name of the slide", "", {}},
                     {"friction", "mu_ss", "1", "mean steady friction of the replicates", "", {}},
                     {"standard_error", "mu_ss", "1", "standard error of that mean", "", {}}});
}

/// Adds a label for each profile of a slide: its shear strain, and whether the first replicate has liquefied before.
void label_profiles(Legend& legend, const std::vector<SlidePoint>& points, const std::string& slide,
                    const Ensemble& ensemble) {
  const double liquefied = liquefaction_strain(ensemble.front().series);
  for (const SlidePoint& point : points)
    for (std::size_t i = 0; i < point.profiles.strains.size() && point.replicate == 0 && point.name == slide; ++i) {
      const double strain = point.profiles.strains[i];
      legend.add(fmt::format("profile_{}", i + 1), fmt::format("γ = {:.3g} %", 100.0 * strain));
      legend.add(fmt::format("profile_{}_is", i + 1),
                 strain >= liquefied ? "after liquefaction" : "before liquefaction");
    }
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<TriggerCase>(); }

TriggerCase::TriggerCase()
    : SlideCase({"fig08_trigger",
                 "Triggering of a slope by a growing shear stress (Figs. 8, 9 and 10)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 8", "Fig. 9", "Fig. 10"},
                 {}}) {}

std::vector<Metric> TriggerCase::slide_metrics(const SlideOutcome& outcome) const {
  std::vector<Metric> metrics = trigger_metrics(outcome.measures, outcome.series.last("velocity"));
  for (const Metric& metric : profile_metrics(outcome.profiles)) metrics.push_back(metric);
  return metrics;
}

void TriggerCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_ramps(slides, metrics);
  compare_steady_states(slides, metrics);
}

std::vector<std::string> TriggerCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  tables.insert(tables.end(), {"steady_friction", "peaks", "legend"});
  for (const std::string& name : slide_names())
    if (name.ends_with("_hold")) tables.push_back(name + "_friction_band");
  return tables;
}

void TriggerCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  std::string steady = steady_head(), peaks = marked_states_head();
  const Ensembles slides_with_results = results_in(output.path(), points_in(output));
  for (const auto& [name, ensemble] : slides_with_results) {
    peaks += marked_states_row(name, ensemble.front());
    if (!name.ends_with("_hold")) continue;
    std::vector<Series> replicates;
    for (const Result& result : ensemble) replicates.push_back(friction(windows_over(result, "shear_strain")));
    write_table(output.file(name + "_friction_band.dat"), {{{"slide", name}}, band_of_rows(replicates)});
    const std::vector<double> values = values_of(ensemble, "steady_friction");
    if (values.empty()) continue;
    const Statistics all = statistics_of(values);
    steady += fmt::format("{} {} {}\n", name, all.mean, all.standard_error);
  }
  write_atomically(output.file("steady_friction.dat"), steady);
  write_atomically(output.file("peaks.dat"), peaks);

  Legend legend;
  for (const auto& [name, ensemble] : slides_with_results) label_profiles(legend, slides(), name, ensemble);
  legend.write(output);
}

}  // namespace flowslide
