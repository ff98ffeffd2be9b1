// SPDX-License-Identifier: GPL-2.0-or-later
#include "void_ratio_case.hpp"

#include <fmt/format.h>

#include "input/read_samples.hpp"
#include "mobility.hpp"
#include "program/runout.hpp"

namespace flowslide {

std::unique_ptr<Case> make_case() { return std::make_unique<VoidRatioCase>(); }

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

void VoidRatioCase::read(const Configuration& configuration) {
  for (const std::string& name : samples_in_use(configuration))
    if (const std::string key = "sample." + name + ".paper_void_ratio"; configuration.has(key))
      paper_void_ratios_[name] = configuration.number(key, Range::inside(0.55, 1.0));
  SlideCase::read(configuration);
}

std::vector<Metric> VoidRatioCase::more_parameters(const SlidePoint& point) const {
  const auto found = paper_void_ratios_.find(point.sample.name);
  const double value = found == paper_void_ratios_.end() ? point.sample.target.void_ratio : found->second;
  return {{"paper_void_ratio", value, "1", "void ratio of the sample in the paper"}};
}

std::vector<std::string> VoidRatioCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  for (const std::string& name : slide_names()) tables.push_back(name + "_coarse");
  tables.insert(tables.end(), {"sweep", "legend"});
  return tables;
}

void VoidRatioCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Column axis{"paper_void_ratio", "e_0", "1", "void ratio of the sample in the paper", "", {}};
  write_sweep(output, description().name, results_in(output.path(), points_in(output)),
              {axis,
               {"initial_void_ratio", "initial_probe_void_ratio", "peak_shear_stress", "largest_velocity", "runout"},
               [](double void_ratio) { return fmt::format("{:.3f}", void_ratio); }});
}

}  // namespace flowslide
