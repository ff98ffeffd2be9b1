// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_parameters.hpp"

#include <fmt/format.h>

#include <cmath>
#include <variant>

#include "grains/measures.hpp"
#include "grains/packing.hpp"

namespace flowslide {
namespace {

void add_loading(std::vector<Metric>& parameters, const StressHistory& loading) {
  if (const auto* pulse = std::get_if<SinePulse>(&loading)) {
    parameters.push_back({"amplitude", pulse->amplitude, "Pa", "amplitude of the pulse"});
    parameters.push_back({"duration", pulse->duration, "s", "duration of the pulse"});
  }
  if (const auto* rate = std::get_if<ConstantRate>(&loading)) {
    parameters.push_back({"loading_rate", rate->rate, "Pa/s", "rate of the driving stress"});
    if (std::isfinite(rate->duration))
      parameters.push_back({"loading_duration", rate->duration, "s", "time from which the driving stress is held"});
  }
}

void add_coupling(std::vector<Metric>& parameters, const SlideSettings& settings) {
  parameters.push_back({"time_step", settings.time_step, "s", "global time step dt_G"});
  const auto add_least = [&](std::int64_t steps) {
    parameters.push_back({"least_steps", static_cast<double>(steps), "1", "n_accum"});
  };
  if (const auto* rule = std::get_if<CarryRemainder>(&settings.passing.rule)) add_least(rule->least_steps);
  if (const auto* rule = std::get_if<AccumulateAndReset>(&settings.passing.rule)) add_least(rule->least_steps);
  if (settings.adaptive)
    parameters.push_back({"largest_local_time_step", settings.adaptive->largest, "s", "upper bound of adaptive dt_L"});
  if (const auto* rule = std::get_if<ConstantInertialNumber>(&settings.rate))
    parameters.push_back({"smallest_rate", rule->smallest_rate, "1/s", "smallest rate of the sample"});
}

}  // namespace

std::vector<Metric> parameters_of(const SlidePoint& point, const std::optional<double>& number) {
  const SampleRecipe& recipe = point.sample.recipe;
  std::vector<Metric> parameters{{"void_ratio", point.sample.target.void_ratio, "1", "required void ratio"},
                                 {"local_time_step", point.settings.passing.time_step, "s", "local time step dt_L"}};
  if (number) parameters.push_back({"inertial_number", *number, "1", "inertial number of the rate rule"});
  if (point.test) {
    const double own = inertial_number(point.test->shear_rate, lattice_packing(recipe.packing).mean_diameter(),
                                       recipe.material.density, recipe.normal_stress);
    parameters.push_back({"inertial_number", own, "1", "inertial number under the initial normal stress"});
    parameters.push_back({"shear_rate", point.test->shear_rate, "1/s", "shear rate"});
    parameters.push_back({"final_strain", point.test->final_strain, "1", "shear strain at the end"});
    return parameters;
  }
  const SlopeProperties& slope = point.settings.slope;
  parameters.push_back({"hydraulic_conductivity", slope.hydraulic_conductivity, "m/s", "hydraulic conductivity"});
  parameters.push_back({"angle", slope.angle, "rad", "angle of the slope"});
  add_coupling(parameters, point.settings);
  add_loading(parameters, point.settings.loading);
  return parameters;
}

std::string describe(const StressHistory& loading) {
  if (const auto* pulse = std::get_if<SinePulse>(&loading))
    return fmt::format("pulse of {:.3g} kPa over {:.3g} s", 1e-3 * pulse->amplitude, pulse->duration);
  if (const auto* rate = std::get_if<ConstantRate>(&loading)) {
    const std::string text = fmt::format("{:.3g} kPa/s", 1e-3 * rate->rate);
    return std::isfinite(rate->duration) ? fmt::format("{} for {:.3g} s", text, rate->duration) : text;
  }
  const auto* table = std::get_if<StressTable>(&loading);
  if (table == nullptr) return "constant load";
  if (table->time.size() == 1) return fmt::format("change of {:.3g} kPa", 1e-3 * table->change.front());
  return fmt::format("table of {} points", table->time.size());
}

}  // namespace flowslide
