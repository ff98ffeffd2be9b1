// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_point.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "configuration/error.hpp"
#include "dem/make_engine.hpp"
#include "grains/packing.hpp"
#include "input/read_coupling.hpp"
#include "input/read_profile_plan.hpp"
#include "input/read_samples.hpp"
#include "input/read_shear_test.hpp"
#include "program/plan.hpp"
#include "program/slide_parameters.hpp"

namespace flowslide {
namespace {

constexpr int free_slide_steps = 1000;     ///< time steps of the slide on a sample without strength
constexpr double strain_at_peak = 0.01;    ///< about the strain at the peak of loose samples; up to it p is about p_0

const SampleSpecification& sample_named(const Configuration& configuration, const std::string& key,
                                        const std::vector<SampleSpecification>& samples) {
  const std::string name = configuration.text(key, configuration.subtables("sample"));
  const auto found = std::ranges::find(samples, name, &SampleSpecification::name);
  if (found == samples.end()) configuration.refuse(key, "names a sample that was not read", "report this defect");
  return *found;
}

/// The recipe of the grains that the engine of a point moves; null for a closed form.
const SampleRecipe* moved_grains(const SlidePoint& point) {
  return seconds_per_grain_and_step(point.engine) > 0.0 ? &point.sample.recipe : nullptr;
}

double predicted_seconds(const SampleRecipe& recipe, double steps, const std::string& engine) {
  const auto& counts = recipe.packing.counts;
  const double sites = std::max(1.0, static_cast<double>(counts[0]) * counts[1] * counts[2]);
  return steps * sites * seconds_per_grain_and_step(engine);
}

/// The engine of a point. `common` is the engine of the case.
std::string engine_of(const Tables& table, const std::string& common) {
  if (!table.has("engine")) return common;
  const std::string own = table.text("engine", engine_names());
  return seconds_per_grain_and_step(common) > 0.0 ? own : common;
}

void read_test(const Configuration& configuration, std::vector<std::string> tables, SlidePoint& read) {
  const TableNames coupling = within(tables, "coupling", {"coupling"});
  tables.emplace_back("shear_test");
  read.test = read_shear_test(configuration, tables, read.sample.recipe);
  read.settings.passing.time_step = read_local_time_step(configuration, coupling, moved_grains(read));
  read.test->adaptive = read_adaptive_time_step(configuration, coupling, read.settings.passing.time_step);
  std::vector<std::string> places = tables;
  places.insert(places.end(), coupling.names().begin(), coupling.names().end());
  const auto steps = as_written_by_user(fmt::format("{}: run {}", configuration.place_of(places), read.name), [&] {
    return static_cast<double>(read.test->steps(read.settings.passing.time_step));
  });
  read.parameters = parameters_of(read, std::nullopt);
  read.point.description = fmt::format("sample {} (seed {}) alone, {:.3g} /s to {:.3g} %", read.sample.name,
                                       read.sample.recipe.packing.seed, read.test->shear_rate,
                                       100.0 * read.test->final_strain);
  read.point.predicted_seconds = predicted_seconds(read.sample.recipe, steps, read.engine);
}

std::string describe_slide(const SlidePoint& point, const std::string& scheme) {
  const bool closed_form = seconds_per_grain_and_step(point.engine) == 0.0;
  const std::string sample =
      closed_form ? fmt::format("closed-form sample {}", point.engine)
                  : fmt::format("sample {} (seed {})", point.sample.name, point.sample.recipe.packing.seed);
  return fmt::format("{}, {}, {}, k = {:.3g} m/s, to {:.3g} s", sample, scheme, describe(point.settings.loading),
                     point.settings.slope.hydraulic_conductivity, point.stop.end_time);
}

/// Checks that depend on several keys. A run that passes them can fail only numerically.
/// `place` is where the settings of the point stand (see Configuration::place_of).
void check_together(const Tables& table, const SlidePoint& point, const std::string& place) {
  const SlideSettings& settings = point.settings;
  as_written_by_user(fmt::format("{}: run {}", place, point.name), [&] {
    validate(settings);
    validate(point.stop);
  });
  if (seconds_per_grain_and_step(point.engine) == 0.0 || settings.residual == ResidualTreatment::stays) return;
  const double driving = initial_shear_stress(settings.slope), prepared = point.sample.recipe.shear_stress;
  if (std::abs(driving - prepared) <= largest_residual * initial_normal_stress(settings.slope)) return;
  table.refuse("sample",
               fmt::format("is prepared to tau = {:.4g} Pa, but the slope starts with {:.4g} Pa: they may differ by {} "
                           "sigma_0 at most",
                           prepared, driving, largest_residual),
               "choose a sample that is not isotropic, or set residual = \"stays\"");
}

}  // namespace

SlidePoint read_slide_point(const Configuration& configuration, const std::string& name, const CommonSettings& common) {
  const std::vector<std::string> tables = with_like(configuration, "point", name);
  const Tables table(configuration, tables);
  SlidePoint read;
  read.name = name;
  read.replicate = common.replicate;
  read.sample = sample_named(configuration, table.key("sample"), common.samples);
  read.point.name = replicate_name(name, common.replicate);
  read.point.curve = name;
  read.point.sample = read.sample.label();
  read.point.figures = configuration.texts(table.key("figures"));
  const Assembly packing = lattice_packing(read.sample.recipe.packing);
  read.grains = {packing.mean_diameter(), read.sample.recipe.material.density};
  read.point.grains = static_cast<int>(packing.size());
  read.published = configuration.is_published("point." + name);
  read.engine = engine_of(table, common.engine);
  read.point.inputs.engine = read.engine;
  if (table.has("final_strain")) {
    read_test(configuration, tables, read);
    return read;
  }
  const SampleRecipe& recipe = read.sample.recipe;
  const std::string scheme = table.text("scheme", configuration.subtables("scheme"));
  const TableNames coupling = within(tables, "coupling", {"scheme." + scheme, "coupling"});

  SlopeProperties own_slope = common.slope;
  if (table.has("hydraulic_conductivity"))
    own_slope.hydraulic_conductivity =
        table.quantity("hydraulic_conductivity", dimension::velocity, Range::not_negative());
  read.settings = read_coupling(configuration, coupling, own_slope, read.grains, moved_grains(read));
  const TableNames loading = within(tables, "loading", {"loading"});
  read.settings.loading = read_loading(configuration, loading);
  read.point.inputs.tables = loading_inputs(configuration, loading, read.settings.loading);
  const Tables settings(configuration, coupling);
  read.linear_start = settings.has("linear_start") && settings.flag("linear_start");
  read.stop = read_stop(configuration, within(tables, "stop", {"stop"}));
  read.rows = read_row_spacing(configuration, within(tables, "rows", {"rows"}));
  read.profiles = read_profile_plan(configuration, table.key("profile_strains"));
  std::vector<std::string> places = tables;
  places.insert(places.end(), {"scheme." + scheme, "coupling", "loading", "stop"});
  check_together(table, read, configuration.place_of(places));

  read.point.description = describe_slide(read, scheme);
  std::optional<double> number;
  if (!std::holds_alternative<GlobalRate>(read.settings.rate))
    number = settings.number("inertial_number", Range::positive());
  read.parameters = parameters_of(read, number);
  read.point.predicted_seconds = predicted_seconds(recipe, predicted_steps(read.settings, read.stop), read.engine);
  return read;
}

SlidePoint on_sample(SlidePoint point, double mean_diameter) {
  point.grains.mean_diameter = mean_diameter;
  if (!point.test) {
    point.settings.rate = for_grains(point.settings.rate, point.grains, initial_normal_stress(point.settings.slope));
    return point;
  }
  point.test = for_sample(*point.test, point.sample.recipe, mean_diameter);
  const SampleRecipe& recipe = point.sample.recipe;
  for (Metric& parameter : point.parameters) {
    if (parameter.name == "shear_rate") parameter.value = point.test->shear_rate;
    if (parameter.name == "inertial_number")
      parameter.value = inertial_number(point.test->shear_rate, mean_diameter, recipe.material.density,
                                        recipe.normal_stress);
  }
  return point;
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
    const double first = rate_asked(settings.rate, 0.0, initial_normal_stress(settings.slope), 0.0);
    duration = std::max(strain_at_peak, rule->smallest_rate_from) / first +
               strain / std::max(rule->smallest_rate, 1e-3 * first);
  }
  if (const auto* rule = std::get_if<ConstantStrainRate>(&settings.rate)) duration = strain / rule->rate;
  const bool waits = std::holds_alternative<AccumulateAndReset>(settings.passing.rule) ||
                     std::holds_alternative<CarryRemainder>(settings.passing.rule);
  return duration / settings.passing.time_step + (waits ? 0.0 : time / settings.time_step);
}

}  // namespace flowslide
