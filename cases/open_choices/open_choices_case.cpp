// SPDX-License-Identifier: GPL-2.0-or-later
#include "open_choices_case.hpp"

#include <array>
#include <cmath>

#include "choices_table.hpp"
#include "contact_metrics.hpp"
#include "dem/make_engine.hpp"
#include "jam.hpp"
#include "program/runout.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

/// Whether a run is of the map. The others change one choice at a time.
bool is_of_map(const std::string& name) { return name.starts_with("off_") || name.starts_with("on_"); }

/// A row for each run of the map. Strains that were not reached are those of the end of the test, and `jams` tells them
/// apart.
Series map_of(const Ensembles& runs) {
  Series map;
  map.axis = {"shear_rate", "gamma_dot", "1/s", "shear rate", "", {}};
  map.columns = {{"void_ratio", "e_0", "1", "void ratio of the cell before shear", "", {}},
                 {"probe_void_ratio", "e_0", "1", "void ratio without the outer 7.5 % of the height", "", {}},
                 {"torsion_resistance", "", "1", "1: the material resists torsion", "", {}},
                 {"jams", "", "1", "1: tau exceeds 10 % of sigma_0 from some strain to the end", "", {}},
                 {"strain", "gamma", "1", "strain from which it does, or the strain at the end", "", {}},
                 {"largest_burst", "tau/sigma_0", "1", "largest tau after liquefaction and before that", "", {}}};
  for (const auto& [name, ensemble] : runs) {
    if (!is_of_map(name)) continue;
    for (const Result& result : ensemble) {
      const bool jams = metric_of(result, "jams") == 1.0;
      const double strain = jams ? metric_of(result, "strain_above_10") : result.series.last("shear_strain");
      const double burst = metric_of(result, "largest_burst");
      map.append_row(metric_of(result, "shear_rate_of_test"),
                     std::array{metric_of(result, "initial_void_ratio"), metric_of(result, "initial_probe_void_ratio"),
                                metric_of(result, "torsion_resistance"), jams ? 1.0 : 0.0, strain,
                                std::isfinite(burst) ? burst : 0.0});
    }
  }
  return map;
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<OpenChoicesCase>(); }

OpenChoicesCase::OpenChoicesCase()
    : SlideCase({"open_choices", "What the paper leaves unsaid: which samples jam, and one choice at a time",
                 FLOWSLIDE_VERSION, {"open_choices"}, engine_names()}) {}

std::vector<Metric> OpenChoicesCase::slide_metrics(const SlideOutcome& outcome) const {
  if (!outcome.point.test) return pulse_runout(outcome);
  const SampleRecipe& recipe = outcome.point.sample.recipe;
  const ShearTest& test = *outcome.point.test;
  const bool lasts = outcome.series.last("normal_stress") >= test.end_normal_stress;
  std::vector<Metric> metrics = metrics_of(jam_of(outcome.series, recipe.normal_stress, lasts), recipe.normal_stress);
  metrics.push_back({"shear_rate_of_test", test.shear_rate, "1/s", "shear rate"});
  metrics.push_back({"torsion_resistance", recipe.material.torsion_resistance ? 1.0 : 0.0, "1",
                     "1: the material resists torsion"});
  metrics.push_back({"peak_shear_stress", outcome.measures.peak_to_5.stress, "Pa",
                     "largest shear stress up to 5 % strain"});
  if (outcome.grains == nullptr) return metrics;
  for (const Metric& metric : contact_metrics(outcome.grains->assembly(), recipe.material,
                                              outcome.point.settings.passing.time_step))
    metrics.push_back(metric);
  return metrics;
}

std::vector<std::string> OpenChoicesCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  tables.emplace_back("map");
  return tables;
}

void OpenChoicesCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles runs = results_in(output.path(), points_in(output));
  write_table(output.file("map.dat"), {{}, map_of(runs)});
  write_atomically(output.file("choices.md"), choices_table(runs));
}

}  // namespace flowslide
