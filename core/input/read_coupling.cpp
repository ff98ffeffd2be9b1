// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_coupling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "configuration/error.hpp"
#include "configuration/tables.hpp"
#include "experiment/loading_record.hpp"
#include "input/read_loading_table.hpp"
#include "input/read_samples.hpp"

namespace flowslide {
namespace {

constexpr double most_steps_allowed = 1e12;  // a double represents every integer up to this number

ConstantRate read_constant_rate(const Tables& table) {
  ConstantRate loading{table.quantity("rate", dimension::stress_rate)};
  if (table.has("duration")) loading.duration = table.positive("duration", dimension::time);
  if (!table.has("final_change")) return loading;
  const double final_change = table.quantity("final_change", dimension::stress);
  if (table.has("duration"))
    table.refuse("final_change", fmt::format("conflicts with \"{}\", which is given too", table.key("duration")),
                 "leave one of them out");
  loading.duration = final_change / loading.rate;
  if (!(loading.duration > 0.0 && std::isfinite(loading.duration)))
    table.refuse("final_change", fmt::format("is never reached at the rate {} Pa/s", loading.rate),
                 "give both the same sign");
  return loading;
}

std::optional<LiquefiedRest> read_rest(const Tables& coupling) {
  coupling.accept({"probed_strain", "rested_strain"}, "it needs rest_stress");
  if (!coupling.has("rest_stress")) return std::nullopt;
  return LiquefiedRest{coupling.positive("rest_stress", dimension::stress),
                       coupling.positive("probed_strain", dimension::dimensionless),
                       coupling.positive("rested_strain", dimension::dimensionless)};
}

/// Refuses a rest where the strain that it leaves out would be missed (see LiquefiedRest).
void check_rest(const Tables& coupling, const SlideSettings& settings) {
  if (!settings.rest) return;
  const bool follows_slope = std::holds_alternative<GlobalRate>(settings.rate) ||
                             std::holds_alternative<GlobalRateAtLeastQuasiStatic>(settings.rate);
  if (follows_slope)
    coupling.refuse("rest_stress",
                    fmt::format("leaves strain out, and {} = \"{}\" passes the rate of the slope, at which a liquefied "
                                "sample bears stress", coupling.key("rate"), coupling.text("rate")),
                    "use it with rate = \"constant_inertial_number\" (RI), or leave it out");
  if (settings.slope.hydraulic_conductivity > 0.0)
    coupling.refuse("rest_stress",
                    fmt::format("leaves strain out, and with a hydraulic conductivity of {} m/s this is compression, "
                                "too, by which the sample would regain strength",
                                settings.slope.hydraulic_conductivity),
                    "leave it out, or use hydraulic_conductivity = 0");
}

/// Why the keys that the choice at `name` does not read have no effect.
std::string not_used_by(const Tables& table, const char* name) {
  return fmt::format("{} = \"{}\" does not use it", name, table.text(name));
}

/// The allowed values of most_steps: at least n_accum, `fewest`. Refuses an n_accum of the user above most_steps,
/// because then n_accum is the cause.
Range most_steps_range(const Configuration& configuration, const Tables& table, std::int64_t fewest) {
  if (configuration.is_users(table.key("n_accum"))) {
    const std::int64_t most = table.integer("most_steps", Range::between(1, most_steps_allowed));
    if (fewest > most)
      table.refuse("n_accum",
                   fmt::format("is above {} = {}, the largest number of local steps of one exchange",
                               table.key("most_steps"), most),
                   fmt::format("choose n_accum from 1 to {}", most));
  }
  return Range::between(static_cast<double>(fewest), most_steps_allowed);
}

/// Refuses dt_G above `limit` (s), the limit of stability of `what`.
void check_stability(const Tables& table, double time_step, double limit, const std::string& what) {
  if (time_step <= limit) return;
  table.refuse("time_step", fmt::format("is unstable: {} allows at most {:.3g} s", what, limit),
               "choose a smaller step, or give --allow-unstable to see what happens");
}

/// Refuses n_accum, or stress_interval without it, if the slope would use a held stress for too long: see
/// read_coupling. `swing_limit` is 2/omega, s.
void check_portions(const Tables& table, const SlideSettings& settings, double swing_limit) {
  double least = 1.0;
  if (const auto* carry = std::get_if<CarryRemainder>(&settings.passing.rule))
    least = static_cast<double>(carry->least_steps);
  if (const auto* reset = std::get_if<AccumulateAndReset>(&settings.passing.rule))
    least = static_cast<double>(reset->least_steps);
  const double longest_step =
      settings.adaptive ? std::max(settings.adaptive->largest, settings.passing.time_step) : settings.passing.time_step;
  const auto between_measurements = static_cast<double>(settings.stress_interval);
  if (least == 1.0 && between_measurements == 1.0) return;
  const char* key = least == 1.0 ? "stress_interval" : "n_accum";
  const double duration = least * between_measurements * longest_step;
  const bool at_own_rate = std::holds_alternative<ConstantStrainRate>(settings.rate) ||
                           std::holds_alternative<ConstantInertialNumber>(settings.rate);
  if (!at_own_rate && duration > swing_limit)
    table.refuse(key,
                 fmt::format("holds the stress for {:.3g} s while the slope oscillates: at most {:.3g} s, 2/omega, is "
                             "allowed", duration, swing_limit), "choose a smaller one");
  const double portion = duration * rate_asked(settings.rate, 0.0, initial_normal_stress(settings.slope), 0.0);
  if (portion > largest_portion)
    table.refuse(key,
                 fmt::format("passes a strain of {:.3g} at once, which may hide the peak of the shear stress: at most "
                             "{:.3g} is allowed", portion, largest_portion), "choose a smaller one");
}

}  // namespace

StressHistory read_loading(const Configuration& configuration, const TableNames& tables) {
  const Tables loading(configuration, tables);
  const auto constant = [&]() -> StressHistory {
    if (loading.has("change")) return StressTable{{0.0}, {loading.quantity("change", dimension::stress)}};
    return NoChange{};
  };
  const auto rate = [&]() -> StressHistory { return read_constant_rate(loading); };
  const auto pulse = [&]() -> StressHistory {
    return SinePulse{loading.quantity("amplitude", dimension::stress), loading.positive("duration", dimension::time)};
  };
  const auto table = [&]() -> StressHistory {
    const std::filesystem::path file = loading.path("file");
    try {
      return read_loading_table(file);
    } catch (const ConfigurationError& error) {
      throw ConfigurationError(fmt::format("{}; the key \"{}\" names this file", error.what(), loading.key("file")));
    }
  };
  const StressHistory read = loading.choice<std::function<StressHistory()>>(
      "history", {{"constant", constant}, {"rate", rate}, {"pulse", pulse}, {"table", table}})();
  loading.accept({"change", "rate", "duration", "final_change", "amplitude", "file"}, not_used_by(loading, "history"));
  return read;
}

std::vector<InputTable> loading_inputs(const Configuration& configuration, const TableNames& tables,
                                       const StressHistory& loading) {
  const Tables table(configuration, tables);
  if (table.text("history") != "table") return {};
  return {input_table(table.text("file"), std::get<StressTable>(loading))};
}

RateRule read_rate_rule(const Configuration& configuration, const TableNames& tables, const GrainScale& grains,
                        double initial_normal_stress) {
  const Tables coupling(configuration, tables);
  const auto number = [&] { return coupling.number("inertial_number", Range::positive()); };
  const auto global = []() -> RateRule { return GlobalRate{}; };
  const auto constant = [&]() -> RateRule {
    return for_grains(ConstantStrainRate{0.0, number()}, grains, initial_normal_stress);
  };
  const auto constant_inertial_number = [&]() -> RateRule {
    ConstantInertialNumber rule{number(), coupling.quantity("smallest_rate", dimension::rate, Range::not_negative()),
                                grains};
    if (coupling.has("smallest_rate_from"))
      rule.smallest_rate_from = coupling.number("smallest_rate_from", Range::not_negative());
    return rule;
  };
  const auto at_least = [&]() -> RateRule { return GlobalRateAtLeastQuasiStatic{number(), grains}; };
  const RateRule read =
      coupling.choice<std::function<RateRule()>>("rate", {{"global", global},
                                                          {"constant", constant},
                                                          {"constant_inertial_number", constant_inertial_number},
                                                          {"at_least_quasi_static", at_least}})();
  coupling.accept({"inertial_number", "smallest_rate", "smallest_rate_from"}, not_used_by(coupling, "rate"));
  return read;
}

double read_local_time_step(const Configuration& configuration, const TableNames& tables, const SampleRecipe* moved) {
  const Tables coupling(configuration, tables);
  if (moved == nullptr) return coupling.positive("local_time_step", dimension::time);
  return read_grain_time_step(configuration, coupling.key("local_time_step"), moved->packing.smallest_diameter,
                              moved->material);
}

StrainPassing read_strain_passing(const Configuration& configuration, const TableNames& tables,
                                  const SampleRecipe* moved) {
  const Tables coupling(configuration, tables);
  StrainPassing passing;
  passing.time_step = read_local_time_step(configuration, tables, moved);
  std::int64_t fewest = 1;
  const auto least = [&] { return fewest = coupling.integer("n_accum", Range::between(1, most_steps_allowed)); };
  using Rule = decltype(passing.rule);
  passing.rule = coupling.choice<std::function<Rule()>>(
      "passing", {{"carry_remainder", [&]() -> Rule { return CarryRemainder{least()}; }},
                  {"accumulate_and_reset", [&]() -> Rule { return AccumulateAndReset{least()}; }},
                  {"whole_increment", []() -> Rule { return WholeIncrement{}; }},
                  {"variable_time_step", []() -> Rule { return VariableTimeStep{}; }}})();
  coupling.accept({"n_accum"}, not_used_by(coupling, "passing"));
  passing.most_steps = coupling.integer("most_steps", most_steps_range(configuration, coupling, fewest));
  return passing;
}

std::optional<AdaptiveTimeStep> read_adaptive_time_step(const Configuration& configuration, const TableNames& tables,
                                                        double smallest) {
  const Tables coupling(configuration, tables);
  const char* key = "largest_local_time_step";
  if (!coupling.has(key)) return std::nullopt;
  const double largest = coupling.positive(key, dimension::time);
  if (largest < smallest)
    coupling.refuse(key, fmt::format("is below local_time_step, {} s", smallest), "leave it out for a constant dt_L");
  return AdaptiveTimeStep{smallest, largest};
}

SlideSettings read_coupling(const Configuration& configuration, const TableNames& tables, const SlopeProperties& slope,
                            const GrainScale& grains, const SampleRecipe* moved) {
  const Tables coupling(configuration, tables);
  SlideSettings settings;
  settings.slope = slope;
  settings.time_step = coupling.positive("time_step", dimension::time);
  settings.rate = read_rate_rule(configuration, tables, grains, initial_normal_stress(slope));
  settings.passing = read_strain_passing(configuration, tables, moved);
  settings.consolidation = coupling.choice<ConsolidationScheme>(
      "consolidation", {{"exponential", ConsolidationScheme::exponential}, {"euler", ConsolidationScheme::euler}});
  settings.residual = coupling.choice<ResidualTreatment>("residual", {{"fades", ResidualTreatment::fades},
                                                                      {"left_out", ResidualTreatment::left_out},
                                                                      {"stays", ResidualTreatment::stays}});
  if (coupling.has("initial_velocity"))
    settings.initial_velocity = coupling.quantity("initial_velocity", dimension::velocity);
  if (coupling.has("stress_interval"))
    settings.stress_interval = coupling.integer("stress_interval", Range::between(1, most_steps_allowed));
  settings.adaptive = read_adaptive_time_step(configuration, tables, settings.passing.time_step);
  settings.rest = read_rest(coupling);
  check_rest(coupling, settings);
  const double shear_modulus = coupling.positive("shear_modulus", dimension::stress);
  settings.oedometric_modulus = coupling.positive("oedometric_modulus", dimension::stress);
  if (coupling.flag("allow_unstable")) return settings;
  check_stability(coupling, settings.time_step, sliding_time_step_limit(slope, shear_modulus),
                  fmt::format("sliding on a sample of G = {:.3g} Pa, 2/omega,", shear_modulus));
  check_portions(coupling, settings, sliding_time_step_limit(slope, shear_modulus));
  const double modulus = settings.oedometric_modulus;
  if (settings.consolidation == ConsolidationScheme::euler)
    check_stability(coupling, settings.time_step, consolidation_time_step_limit(slope, modulus),
                    fmt::format("forward Euler for drainage with M = {:.3g} Pa, 2/(M C),", modulus));
  return settings;
}

StopConditions read_stop(const Configuration& configuration, const TableNames& tables) {
  const Tables stop(configuration, tables);
  StopConditions conditions;
  conditions.end_time = stop.positive("end_time", dimension::time);
  if (stop.has("end_shear_strain"))
    conditions.end_shear_strain = stop.positive("end_shear_strain", dimension::dimensionless);
  if (stop.has("end_velocity")) conditions.end_velocity = stop.positive("end_velocity", dimension::velocity);
  if (stop.has("sliding_velocity"))
    conditions.sliding_velocity = stop.positive("sliding_velocity", dimension::velocity);
  return conditions;
}

RowSpacing read_row_spacing(const Configuration& configuration, const TableNames& tables) {
  const Tables rows(configuration, tables);
  RowSpacing spacing;
  spacing.most_rows = rows.integer("most_rows", Range::between(10, 1e6));
  if (rows.has("row_interval")) spacing.interval = rows.positive("row_interval", dimension::time);
  if (rows.has("row_strain")) spacing.strain = rows.positive("row_strain", dimension::dimensionless);
  if (!rows.has("row_interval") && !rows.has("row_strain"))
    rows.refuse("most_rows", "does not give the spacing of rows", "give row_interval, row_strain or both");
  return spacing;
}

void check_strength(const Configuration& configuration, const SlopeProperties& slope, double friction) {
  const double ratio = initial_shear_stress(slope) / initial_normal_stress(slope);
  if (ratio < friction) return;
  configuration.refuse("slope.angle",
                       fmt::format("makes tau_0/sigma_0 = {:.3g}, but a sample with friction {:.3g} bears less than "
                                   "{:.3g}", ratio, friction, friction),
                       "make the slope flatter or the grains rougher");
}

}  // namespace flowslide
