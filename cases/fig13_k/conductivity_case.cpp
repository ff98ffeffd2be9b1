// SPDX-License-Identifier: GPL-2.0-or-later
#include "conductivity_case.hpp"

#include "critical_conductivity.hpp"
#include "program/runout.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {

std::unique_ptr<Case> make_case() { return std::make_unique<ConductivityCase>(); }

ConductivityCase::ConductivityCase()
    : SlideCase({"fig13_k",
                 "Runout of a slope at several hydraulic conductivities (Fig. 13)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 13"},
                 {}}) {}

std::vector<Metric> ConductivityCase::slide_metrics(const SlideOutcome& outcome) const { return pulse_runout(outcome); }

void ConductivityCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_conductivities(slides, metrics);
}

std::vector<std::string> ConductivityCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  for (const std::string& name : slide_names()) tables.push_back(name + "_coarse");
  tables.insert(tables.end(), {"sweep", "critical", "legend"});
  return tables;
}

void ConductivityCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles slides = results_in(output.path(), points_in(output));
  write_sweep(output, description().name, slides,
              {{"hydraulic_conductivity", "k", "m/s", "hydraulic conductivity", "", {}},
               {"largest_velocity", "runout", "sliding_stopped"},
               label_of_quantity});
  write_table(output.file("critical.dat"), {{{"case", description().name}}, critical_series(slides)});
}

}  // namespace flowslide
