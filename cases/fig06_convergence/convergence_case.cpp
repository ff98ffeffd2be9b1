// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence_case.hpp"

#include "convergence.hpp"
#include "error_table.hpp"
#include "program/runout.hpp"
#include "record/atomic_file.hpp"
#include "run/legend.hpp"

namespace flowslide {

std::unique_ptr<Case> make_case() { return std::make_unique<ConvergenceCase>(); }

ConvergenceCase::ConvergenceCase()
    : SlideCase({"fig06_convergence",
                 "A slope on a sample of given inertial number as dt_G shrinks (Figs. 6 and 7)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 6", "Fig. 7"},
                 {}}) {}

std::vector<Metric> ConvergenceCase::slide_metrics(const SlideOutcome& outcome) const {
  return peak_metrics(outcome.measures);
}

void ConvergenceCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_with_grains(slides, metrics);
}

std::vector<std::string> ConvergenceCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  tables.insert(tables.end(), {"legend", "errors"});
  return tables;
}

void ConvergenceCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const std::vector<std::string> present = points_in(output);
  Legend legend;
  for (const auto& [name, ensemble] : results_in(output.path(), present))
    if (are_slides(ensemble)) legend.add(name, label_of_quantity(parameter_of(ensemble, "time_step")));
  legend.write(output);
  const Ensembles runs = results_in(output.path(), present);
  const std::map<std::string, double> all = metrics(output.path(), present);
  write_atomically(output.file("errors.dat"), error_rows(runs, all));
  const std::string table = error_table(runs, all);
  if (!table.empty()) write_atomically(output.file("table.md"), table);
}

}  // namespace flowslide
