// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/slide_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/coupling_models.hpp"
#include "app/plan.hpp"
#include "grains/packing.hpp"

namespace flowslide {
namespace {

constexpr int free_slide_steps = 1000;     ///< enough for a prediction
constexpr double strain_at_peak = 0.01;    ///< about that of loose samples: passed at the rate of the full stress

const SampleSpecification& sample_named(const Configuration& configuration, const std::string& key,
                                        const std::vector<SampleSpecification>& samples) {
  std::vector<std::string> names;
  for (const SampleSpecification& sample : samples) names.push_back(sample.name);
  const std::string name = configuration.text(key, names);
  return samples[static_cast<std::size_t>(std::find(names.begin(), names.end(), name) - names.begin())];
}

std::string describe(const SlidePoint& point, const std::string& scheme) {
  return fmt::format("sample {} (seed {}), {}, k = {:.3g} m/s, to {:.3g} s", point.sample.name,
                     point.sample.recipe.packing.seed, scheme, point.settings.slope.hydraulic_conductivity,
                     point.stop.end_time);
}

}  // namespace

SlidePoint read_slide_point(const Configuration& configuration, const std::string& name, int replicate,
                            const std::vector<SampleSpecification>& samples, const SlopeProperties& slope,
                            const std::string& engine, const std::filesystem::path& folder) {
  const std::string table = "point." + name + ".";
  SlidePoint read;
  read.name = name;
  read.replicate = replicate;
  read.sample = sample_named(configuration, table + "sample", samples);
  const SampleRecipe& recipe = read.sample.recipe;
  const std::string scheme = configuration.text(table + "scheme", configuration.subtables("scheme"));
  const TableNames coupling{table + "coupling", "scheme." + scheme, "coupling"};

  SlopeProperties own_slope = slope;
  if (configuration.has(table + "hydraulic_conductivity"))
    own_slope.hydraulic_conductivity =
        configuration.quantity(table + "hydraulic_conductivity", dimension::velocity, Range::not_negative());
  const GrainScale grains{lattice_packing(recipe.packing).mean_diameter(), recipe.material.density};
  read.settings = read_coupling(configuration, coupling, own_slope, grains);
  read.settings.loading = read_loading(configuration, {table + "loading", "loading"}, folder);
  if (seconds_per_grain_and_step(engine) > 0.0)
    check_time_step(configuration, Tables(configuration, coupling).key("local_time_step"),
                    recipe.packing.smallest_diameter, recipe.material);
  read.stop = read_stop(configuration, {table + "stop", "stop"});
  read.rows = read_row_spacing(configuration, {table + "rows", "rows"});
  read.profiles = read_profile_plan(configuration, table + "profile_strains");

  const double sites = std::max<double>(1.0, static_cast<double>(recipe.packing.counts[0]) * recipe.packing.counts[1] *
                                                 recipe.packing.counts[2]);
  read.point = {replicate_name(name, replicate), configuration.texts(table + "figures"), describe(read, scheme),
                predicted_steps(read.settings, read.stop) * sites * seconds_per_grain_and_step(engine)};
  return read;
}

double predicted_steps(const SlideSettings& settings, const StopConditions& stop) {
  const DrivingStress driving(settings.slope, settings.loading);
  const double height = settings.slope.liquefiable_thickness, mass = mass_per_area(settings.slope);
  const double step = stop.end_time / free_slide_steps;
  double velocity = 0.0, strain = 0.0, time = 0.0;
  for (; time < stop.end_time && strain < stop.end_shear_strain; time += step) {
    velocity += step * driving.at(time) / mass;
    strain += step * std::max(velocity, 0.0) / height;
  }
  double duration = time;
  if (const auto* rule = std::get_if<ConstantInertialNumber>(&settings.rate)) {
    const double first = rate_asked(settings.rate, 0.0, initial_normal_stress(settings.slope));
    duration = strain_at_peak / first + strain / std::max(rule->smallest_rate, 1e-3 * first);
  }
  return duration / settings.passing.time_step;
}

}  // namespace flowslide
