// SPDX-License-Identifier: GPL-2.0-or-later
#include "conductivity_case.hpp"

#include "app/runout.hpp"
#include "critical_conductivity.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {

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

void ConductivityCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles slides = results_in(output.path(), points_in(output));
  for (const auto& [name, ensemble] : slides)
    write_table(output.file(name + "_coarse.dat"),
                {{{"case", description().name}, {"slide", name}}, coarse_band(ensemble)});
  const Column axis{"hydraulic_conductivity", "k", "m/s", "hydraulic conductivity", "", {}};
  const Series sweep = sweep_series(axis, {{"RD", sweep_of(slides, "RD_")}, {"RI", sweep_of(slides, "RI_")}},
                                    {"largest_velocity", "runout", "sliding_stopped"});
  write_table(output.file("sweep.dat"), {{{"case", description().name}}, sweep});
  write_table(output.file("critical.dat"), {{{"case", description().name}}, critical_series(slides)});
}

}  // namespace flowslide
