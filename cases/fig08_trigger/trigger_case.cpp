// SPDX-License-Identifier: GPL-2.0-or-later
#include "trigger_case.hpp"

#include <fmt/format.h>

#include "comparison.hpp"
#include "profile_metrics.hpp"
#include "record/gnuplot_table.hpp"
#include "trigger_metrics.hpp"

namespace flowslide {

TriggerCase::TriggerCase()
    : SlideCase({"fig08_trigger",
                 "Triggering of a slope by a growing shear stress (Figs. 8, 9 and 10)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 8", "Fig. 9", "Fig. 10"},
                 {}}) {}

std::vector<Metric> TriggerCase::slide_metrics(const SlideOutcome& outcome) const {
  std::vector<Metric> metrics = trigger_metrics(outcome.series);
  for (const Metric& metric : profile_metrics(outcome.profiles)) metrics.push_back(metric);
  return metrics;
}

void TriggerCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_ramps(slides, metrics);
  compare_steady_states(slides, metrics);
}

void TriggerCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  std::string steady = "# slide\tmean mu_ss\tstandard error\n";
  for (const auto& [name, ensemble] : results_in(output.path(), points_in(output))) {
    if (!name.ends_with("_hold")) continue;
    std::vector<Series> replicates;
    for (const Result& result : ensemble) replicates.push_back(friction(result.series));
    write_table(output.file(name + "_friction_band.dat"), {{{"slide", name}}, band_of_rows(replicates)});
    const std::vector<double> values = values_of(ensemble, "steady_friction");
    if (values.empty()) continue;
    const Statistics all = statistics_of(values);
    steady += fmt::format("{}\t{}\t{}\n", name, all.mean, all.standard_error);
  }
  write_atomically(output.file("steady_friction.dat"), steady);

  std::string legend;
  for (const SlidePoint& slide : slides())
    for (std::size_t i = 0; i < slide.profiles.strains.size() && slide.replicate == 0; ++i)
      legend += fmt::format("profile_{}\tγ = {:.3g} %\n", i + 1, 100.0 * slide.profiles.strains[i]);
  write_atomically(output.file("legend.dat"), legend);
}

}  // namespace flowslide
