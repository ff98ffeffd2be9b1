// SPDX-License-Identifier: GPL-2.0-or-later
#include "pulse_case.hpp"

#include "comparison.hpp"
#include "runout_metrics.hpp"

namespace flowslide {

PulseCase::PulseCase()
    : SlideCase({"fig12_pulse", "Runout of a slope after a sine pulse (Figs. 11 and 12)", FLOWSLIDE_VERSION,
                 {"Fig. 11", "Fig. 12"}, {}},
                FLOWSLIDE_CASE_FOLDER) {}

std::vector<Metric> PulseCase::slide_metrics(const SlideOutcome& outcome) const {
  return runout_metrics(outcome.series, outcome.point.settings);
}

void PulseCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_schemes(slides, metrics);
}

}  // namespace flowslide
