// SPDX-License-Identifier: GPL-2.0-or-later
#include "answers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace flowslide {
namespace {

constexpr int liquefied_profiles[] = {3, 4};  ///< numbers of the profiles; at profile 2 the sample still liquefies

/// The values of a metric of a slide; empty if the slide has no results.
std::vector<double> values(const Ensembles& slides, const std::string& slide, const std::string& metric) {
  const auto found = slides.find(slide);
  return found == slides.end() ? std::vector<double>{} : values_of(found->second, metric);
}

std::vector<double> liquefied_linearities(const Ensembles& slides, const std::string& slide) {
  std::vector<double> all;
  for (const int profile : liquefied_profiles)
    for (const double value : values(slides, slide, fmt::format("linearity_{}", profile))) all.push_back(value);
  return all;
}

/// "median (lowest to highest)" of `numbers` times `factor`; "-" if there is none.
std::string spread(const std::vector<double>& numbers, double factor = 1.0) {
  if (numbers.empty()) return "-";
  const Statistics all = statistics_of(numbers);
  if (numbers.size() == 1) return fmt::format("{:.3g}", factor * all.median);
  return fmt::format("{:.3g} ({:.3g} to {:.3g})", factor * all.median, factor * all.lowest, factor * all.highest);
}

std::string number_of_grains(const Ensembles& slides, const std::string& slide) {
  const std::vector<double> grains = values(slides, slide, "grains");
  return grains.empty() ? "-" : fmt::format("{:.0f}", grains.front());
}

/// The slides on DEM samples whose name begins with `pulse` and that have a largest velocity, by number of grains.
std::vector<std::string> sizes_in(const Ensembles& slides, const std::string& pulse) {
  std::vector<std::string> names;
  for (const auto& [name, ensemble] : slides)
    if (name.starts_with(pulse) && !values_of(ensemble, "largest_velocity").empty() &&
        !values_of(ensemble, "grains").empty())
      names.push_back(name);
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return values(slides, a, "grains").front() < values(slides, b, "grains").front();
  });
  return names;
}

}  // namespace

std::vector<SteadyState> steady_states(const Ensembles& slides) {
  std::vector<SteadyState> states;
  for (const auto& [name, ensemble] : slides) {
    if (!name.starts_with("flow_")) continue;
    for (const Result& result : ensemble) {
      const SteadyState state{metric_of(result, "inertial_number"), metric_of(result, "friction")};
      if (std::isfinite(state.inertial_number + state.friction)) states.push_back(state);
    }
  }
  return states;
}

void add_answers(const Ensembles& slides, std::map<std::string, double>& metrics) {
  if (const auto all = liquefied_linearities(slides, "hold_homogeneous"); !all.empty())
    metrics["least_linearity"] = statistics_of(all).lowest;
  if (const auto all = liquefied_linearities(slides, "hold_glued"); !all.empty())
    metrics["largest_glued_linearity"] = statistics_of(all).highest;
  const std::vector<SteadyState> states = steady_states(slides);
  if (!tell_a_law(states)) return;
  const FrictionLaw law = fit_friction_law(states);
  metrics["mu_s"] = law.slow;
  metrics["mu_2"] = law.fast;
  metrics["I_0"] = law.turning;
  metrics["mu_deviation"] = deviation(states, law);
  metrics["mu_deviation_of_glass_beads"] = deviation(states, law_of_glass_beads());
}

std::string answers_table(const Ensembles& slides) {
  std::string table = "| Question | Glued layers | Homogeneous shear |\n|---|---|---|\n";
  const auto row = [&](const std::string& question, const std::string& glued, const std::string& homogeneous) {
    table += fmt::format("| {} | {} | {} |\n", question, glued, homogeneous);
  };
  const auto of_both = [&](const std::string& question, const std::string& kind, const std::string& metric,
                           double factor = 1.0) {
    row(question, spread(values(slides, kind + "_glued", metric), factor),
        spread(values(slides, kind + "_homogeneous", metric), factor));
  };
  row("grains", number_of_grains(slides, "pulse_glued"), number_of_grains(slides, "pulse_homogeneous"));
  of_both("e_0, probe", "hold", "initial_probe_void_ratio");
  of_both("R^2 of the velocity profile at 10 % strain", "hold", "linearity_2");
  row("R^2 at 30 and 60 % strain, liquefied", spread(liquefied_linearities(slides, "hold_glued")),
      spread(liquefied_linearities(slides, "hold_homogeneous")));
  of_both("mu_ss of the held slope", "hold", "steady_friction");
  of_both("velocity of the held slope at the end (m/s)", "hold", "final_velocity");
  of_both("v_max after the pulse (m/s)", "pulse", "largest_velocity");
  for (const std::string& name : sizes_in(slides, "pulse_homogeneous"))
    if (name != "pulse_homogeneous")
      row(fmt::format("v_max with {} grains (m/s)", number_of_grains(slides, name)), "-",
          spread(values(slides, name, "largest_velocity")));
  const auto of_probe = [&](const std::string& question, const char* metric, double factor = 1.0) {
    row(question, "-", spread(values(slides, "probe_isotropic", metric), factor));
  };
  of_probe("G of the first strain, without shear stress (MPa)", "shear_modulus", 1e-6);
  of_probe("natural frequency of that sample (Hz)", "sample_frequency");
  of_probe("natural frequency of the slope on it (Hz)", "slope_frequency");
  of_both("natural frequency of the sample over the slope's", "probe", "frequency_ratio");
  std::map<std::string, double> fitted;
  add_answers(slides, fitted);
  if (fitted.contains("mu_s"))
    row("mu(I) fitted", "-",
        fmt::format(
            "mu_s = {:.3f}, mu_2 = {:.3f}, I_0 = {:.3g}; states differ by {:.2g}, from the law of glass beads by "
            "{:.2g}",
            fitted["mu_s"], fitted["mu_2"], fitted["I_0"], fitted["mu_deviation"],
            fitted["mu_deviation_of_glass_beads"]));
  return table;
}

Series sizes_series(const Ensembles& slides, const std::string& pulse) {
  Series sizes;
  sizes.axis = {"grains", "N", "1", "number of grains", "", {}};
  for (const char* part : {"median", "lowest", "highest"})
    sizes.columns.push_back({fmt::format("largest_velocity_{}", part), "v_max", "m/s",
                             fmt::format("largest sliding velocity, {} of the replicates", part), "", {}});
  for (const std::string& name : sizes_in(slides, pulse)) {
    const Statistics all = statistics_of(values(slides, name, "largest_velocity"));
    sizes.append_row(values(slides, name, "grains").front(), std::array{all.median, all.lowest, all.highest});
  }
  return sizes;
}

}  // namespace flowslide
