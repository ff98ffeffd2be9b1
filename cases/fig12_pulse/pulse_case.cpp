// SPDX-License-Identifier: GPL-2.0-or-later
#include "pulse_case.hpp"

#include "comparison.hpp"
#include "record/gnuplot_table.hpp"
#include "runout_metrics.hpp"

namespace flowslide {
namespace {
constexpr int windows = 30;  ///< of displacement, for what jumps
}

PulseCase::PulseCase()
    : SlideCase({"fig12_pulse",
                 "Runout of a slope after a sine pulse (Figs. 11 and 12)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 11", "Fig. 12"},
                 {}}) {}

std::vector<Metric> PulseCase::slide_metrics(const SlideOutcome& outcome) const {
  return runout_metrics(outcome.series, outcome.point.settings);
}

void PulseCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  for (const auto& [name, ensemble] : results_in(output.path(), points_in(output)))
    write_table(output.file(name + "_windows.dat"), {{{"slide", name}}, band_over(ensemble, "displacement", windows)});
}

void PulseCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_schemes(slides, metrics);
}

}  // namespace flowslide
