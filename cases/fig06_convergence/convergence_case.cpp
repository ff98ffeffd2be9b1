// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence_case.hpp"

#include "convergence.hpp"
#include "error_table.hpp"
#include "record/atomic_file.hpp"

namespace flowslide {

ConvergenceCase::ConvergenceCase()
    : SlideCase({"fig06_convergence",
                 "A slope on a sample of given inertial number as dt_G shrinks (Figs. 6 and 7)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 6", "Fig. 7"},
                 {}}) {}

std::vector<Metric> ConvergenceCase::slide_metrics(const SlideOutcome& outcome) const {
  return peak_metrics(outcome.series);
}

void ConvergenceCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_with_grains(slides, metrics);
}

void ConvergenceCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const std::string table = error_table(metrics(output.path(), points_in(output)));
  if (!table.empty()) write_atomically(output.file("table.md"), table);
}

}  // namespace flowslide
