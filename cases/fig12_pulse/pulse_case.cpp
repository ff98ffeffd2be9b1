// SPDX-License-Identifier: GPL-2.0-or-later
#include "pulse_case.hpp"

#include <fmt/format.h>

#include <cmath>

#include "after_pulse.hpp"
#include "comparison.hpp"
#include "program/runout.hpp"
#include "record/gnuplot_table.hpp"
#include "run/legend.hpp"

namespace flowslide {
namespace {
constexpr int windows = 30;  ///< windows of displacement for quantities that jump
}

std::unique_ptr<Case> make_case() { return std::make_unique<PulseCase>(); }

PulseCase::PulseCase()
    : SlideCase({"fig12_pulse",
                 "Runout of a slope after a sine pulse (Figs. 11 and 12)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 11", "Fig. 12"},
                 {}}) {}

std::vector<Metric> PulseCase::slide_metrics(const SlideOutcome& outcome) const {
  std::vector<Metric> metrics = pulse_runout(outcome);
  for (const Metric& metric : after_pulse(outcome)) metrics.push_back(metric);
  return metrics;
}

std::vector<std::string> PulseCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  for (const std::string& name : slide_names()) tables.push_back(name + "_windows");
  tables.insert(tables.end(), {"sweep", "legend"});
  return tables;
}

void PulseCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  Legend legend;
  const Ensembles runs = results_in(output.path(), points_in(output));
  const Column axis{"amplitude", "A", "Pa", "amplitude of the pulse", "", {}};
  write_table(output.file("sweep.dat"),
              {{{"case", description().name}},
               sweep_series(axis, {{"RD", sweep_of(runs, "RD_", axis.name)}}, {"largest_velocity"})});
  for (const auto& [name, ensemble] : runs) {
    if (!are_slides(ensemble)) continue;
    write_table(output.file(name + "_windows.dat"), {{{"slide", name}}, band_over(ensemble, "displacement", windows)});
    if (const double amplitude = parameter_of(ensemble, "amplitude"); std::isfinite(amplitude))
      legend.add(name, fmt::format("{{/:Italic A}} = {:.3g} kPa", 1e-3 * amplitude));
  }
  legend.write(output);
}

void PulseCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_schemes(slides, metrics);
}

}  // namespace flowslide
