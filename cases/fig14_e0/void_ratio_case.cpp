// SPDX-License-Identifier: GPL-2.0-or-later
#include "void_ratio_case.hpp"

#include "app/runout.hpp"
#include "mobility.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {

VoidRatioCase::VoidRatioCase()
    : SlideCase({"fig14_e0",
                 "Runout of a slope on samples of four void ratios (Fig. 14)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 14"},
                 {}}) {}

std::vector<Metric> VoidRatioCase::slide_metrics(const SlideOutcome& outcome) const { return pulse_runout(outcome); }

void VoidRatioCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  compare_void_ratios(slides, metrics);
}

void VoidRatioCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles slides = results_in(output.path(), points_in(output));
  for (const auto& [name, ensemble] : slides)
    write_table(output.file(name + "_coarse.dat"),
                {{{"case", description().name}, {"slide", name}}, coarse_band(ensemble)});
  const Column axis{"name", "e_0", "1", "void ratio of the paper's sample, in thousandths", "", {}};
  const std::vector<std::string> metrics{"initial_void_ratio", "initial_bulk_void_ratio", "peak_shear_stress",
                                         "largest_velocity", "runout"};
  const Series sweep =
      sweep_series(axis, {{"RD", sweep_of(slides, "RD_e0_")}, {"RI", sweep_of(slides, "RI_e0_")}}, metrics);
  write_table(output.file("sweep.dat"), {{{"case", description().name}}, sweep});
}

}  // namespace flowslide
