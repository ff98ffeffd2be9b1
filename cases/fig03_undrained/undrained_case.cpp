// SPDX-License-Identifier: GPL-2.0-or-later
#include "undrained_case.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "curve_metrics.hpp"
#include "curves_table.hpp"
#include "dem/make_engine.hpp"
#include "pictures.hpp"
#include "program/runout.hpp"
#include "record/atomic_file.hpp"
#include "run/legend.hpp"

namespace flowslide {
namespace {

std::string picture_key(const std::string& point) { return "point." + point + ".picture_strain"; }

/// Void ratios of the samples in Fig. 3 of the paper.
const std::map<std::string, double> paper_void_ratios{
    {"e0_790", 0.790}, {"e0_771", 0.771}, {"e0_765", 0.765}, {"e0_751", 0.751}};

/// "{I} = 2×10^{−2}", with one digit: the void ratio found changes the others.
std::string label_of_number(double inertial_number) {
  const double power = std::pow(10.0, std::floor(std::log10(inertial_number)));
  return "{/:Italic I} = " + label_of_quantity(std::round(inertial_number / power) * power);
}

/// Label of a curve: the inertial number of the test, or the median void ratio of its samples and, in brackets, that of
/// the paper. Empty for other curves.
std::string label_of(const std::string& name, const Ensemble& ensemble) {
  const double number = statistics_of(ensemble, "initial_inertial_number").median;
  if (name.starts_with("I_")) return std::isfinite(number) && number > 0.0 ? label_of_number(number) : "";
  if (!name.starts_with("e0")) return "";
  const auto paper = paper_void_ratios.find(name);
  const std::string own = fmt::format("{:.3f}", statistics_of(ensemble, "initial_void_ratio").median);
  return paper == paper_void_ratios.end() ? own : fmt::format("{} ({:.3f})", own, paper->second);
}

/// Refuses the names that some keys had before this case used the keys of the other cases.
void refuse_old_keys(const Configuration& configuration) {
  configuration.refuse_renamed("shear.time_step", "coupling.local_time_step");
  configuration.refuse_renamed("shear.final_strain", "point.<name>.final_strain");
  for (const std::string key : {"rows", "shear_rate", "inertial_number"})
    configuration.refuse_renamed("shear." + key, "shear_test." + key);
  for (const std::string& name : configuration.subtables("point"))
    configuration.refuse_renamed("point." + name + ".time_step", "point." + name + ".coupling.local_time_step");
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<UndrainedCase>(); }

UndrainedCase::UndrainedCase()
    : SlideCase({"fig03_undrained",
                 "Constant-volume simple shear of loose packings (Figs. 2, 3 and 4)",
                 FLOWSLIDE_VERSION,
                 {"Fig. 2", "Fig. 3", "Fig. 4"},
                 engine_names()}) {}

void UndrainedCase::read(const Configuration& configuration) {
  refuse_old_keys(configuration);
  for (const std::string& name : configuration.subtables("point"))
    if (configuration.has(picture_key(name)))
      picture_strains_[name] = configuration.number(picture_key(name), Range::not_negative());
  SlideCase::read(configuration);
  for (const SlidePoint& point : slides()) {
    if (!picture_strains_.contains(point.name)) continue;
    const std::string key = picture_key(point.name);
    if (!point.test)
      configuration.refuse(key, "belongs to a point that is not an element test", "give final_strain too");
    configuration.number(key, Range::between(0.0, point.test->final_strain));
  }
}

std::vector<std::string> UndrainedCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  tables.insert(tables.end(), {"legend", "curves", "fig02_before", "fig02_during"});
  return tables;
}

std::vector<Metric> UndrainedCase::slide_metrics(const SlideOutcome& outcome) const {
  if (!outcome.point.test) return {};
  return curve_metrics(outcome.series, outcome.measures.peak_to_5, outcome.point.sample.recipe.normal_stress);
}

void UndrainedCase::compare(const Ensembles&, std::map<std::string, double>& metrics) const {
  const auto slow = metrics.find("I_1e-4.peak_shear_stress.median");
  const auto fast = metrics.find("I_2e-2.peak_shear_stress.median");
  if (slow != metrics.end() && fast != metrics.end()) metrics["rate_effect"] = fast->second / slow->second;
}

std::vector<double> UndrainedCase::picture_strains(const SlidePoint& point) const {
  if (point.replicate != 0) return {};  // one picture: that of the first sample
  const auto strain = picture_strains_.find(point.name);
  return strain == picture_strains_.end() ? std::vector<double>{} : frame_strains(strain->second);
}

void UndrainedCase::write_pictures(const OutputFolder& output, const SlidePoint& point,
                                   const std::vector<Shot>& shots) const {
  write_frames(output, point.point.name, shots);
}

void UndrainedCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  Legend legend;
  std::vector<std::pair<std::string, std::vector<Metric>>> all;
  for (const std::string& name : points_in(output))
    all.emplace_back(name, read_result(output.file(name + ".h5")).metrics);
  for (const auto& [name, ensemble] : results_in(output.path(), points_in(output)))
    if (const std::string label = label_of(name, ensemble); !label.empty()) legend.add(name, label);
  legend.write(output);
  write_atomically(output.file("curves.dat"), curves_table(all));
}

}  // namespace flowslide
