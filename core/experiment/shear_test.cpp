// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/shear_test.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "grains/bulk_mean_stress.hpp"
#include "grains/kinetic_stress.hpp"
#include "grains/measures.hpp"
#include "grains/stress.hpp"

namespace flowslide {
namespace {

/// More steps than any test needs. A double represents every integer up to this number.
constexpr double most_steps = 1e15;

/// One row at the shear strain `strain`. The strain is an argument, because a sum over the runs of the sample would
/// depend, by its rounding, on the number of runs.
std::array<double, 12> row(const DemSample& sample, const Assembly& assembly, double shear_rate, double strain) {
  const Material& material = sample.settings().material;
  const ContactForces forces = evaluate_contact_forces(assembly, material, sample.settings().time_step);
  const SlopeStress bagi = slope_stress(bagi_stress(assembly, forces));
  const SlopeStress nicot = slope_stress(nicot_stress(assembly, forces, material));
  const SlopeStress kinetic = slope_stress(kinetic_stress(assembly, material));
  const double mean = bulk_mean_stress(assembly, forces, material);
  const CellStress told = sample.stress();
  return {strain,
          told.shear,
          told.normal,
          mean,
          inertial_number(shear_rate, assembly.mean_diameter(), material.density, mean),
          sample.void_ratio(),
          bagi.shear,
          bagi.normal,
          nicot.shear,
          nicot.normal,
          kinetic.shear,
          kinetic.normal};
}

/// Strains the sample for `steps` steps of `time_step` (s), or for the same time in fewer steps.
void strain_by(DemSample& sample, const ShearTest& test, std::int64_t steps, double time_step) {
  if (!test.adaptive) {
    sample.strain({{test.shear_rate, 0.0}, steps, time_step});
    return;
  }
  AdaptiveTimeStepState state;
  for (double left = static_cast<double>(steps) * time_step; left > 0.0;) {
    const double longest = choose_time_step(*test.adaptive, sample, state);
    const auto needed = static_cast<std::int64_t>(std::ceil(left / longest));
    const std::int64_t now = std::min(needed, test.adaptive->interval);
    const double length = left / static_cast<double>(needed);
    sample.strain({{test.shear_rate, 0.0}, now, length});
    state.steps += now;
    left = now == needed ? 0.0 : left - static_cast<double>(now) * length;
  }
}

}  // namespace

std::int64_t ShearTest::steps(double time_step) const {
  const double exact = final_strain / (shear_rate * time_step);
  if (!(exact >= 0.0 && exact <= most_steps))
    throw std::invalid_argument(fmt::format(
        "a strain of {} at the rate {} 1/s in time steps of {} s takes {:.3g} of them; it must be 0 to {:.0e}: shear "
        "faster", final_strain, shear_rate, time_step, exact, most_steps));
  return std::max<std::int64_t>(1, std::llround(exact));
}

std::vector<std::int64_t> ShearTest::row_steps(double time_step, int count) const {
  const std::int64_t last = steps(time_step);
  std::vector<std::int64_t> at{0};
  for (int k = 1; k <= count; ++k) {
    const double share = static_cast<double>(k) / count;
    const auto step = static_cast<std::int64_t>(std::llround(share * share * static_cast<double>(last)));
    if (step > at.back()) at.push_back(step);
  }
  return at;
}

ShearTest for_sample(ShearTest test, const SampleRecipe& recipe, double mean_diameter) {
  if (test.inertial_number > 0.0)
    test.shear_rate =
        shear_rate_for(test.inertial_number, mean_diameter, recipe.material.density, recipe.normal_stress);
  return test;
}

Series shear_test_series() {
  const char* shear = "positive downslope";
  const char* compression = "compression positive";
  Series series;
  series.columns = {
      {"shear_strain", "gamma", "1", "shear strain", shear, {}},
      {"shear_stress", "tau", "Pa", "shear stress of the cell, by its boundary and grain forces", shear, {}},
      {"normal_stress", "sigma", "Pa", "normal stress of the cell, by its boundary and grain forces", compression, {}},
      {"mean_stress", "p", "Pa", "mean stress away from the glued layers, with the kinetic part", compression, {}},
      {"inertial_number", "I", "1", "inertial number", "", {}},
      {"void_ratio", "e", "1", "void ratio of the cell", "", {}},
      {"bagi_shear_stress", "tau_B", "Pa", "shear stress by Bagi (eq. 12)", shear, {}},
      {"bagi_normal_stress", "sigma_B", "Pa", "normal stress by Bagi (eq. 12)", compression, {}},
      {"nicot_shear_stress", "tau_N", "Pa", "shear stress by Nicot (eq. 13)", shear, {}},
      {"nicot_normal_stress", "sigma_N", "Pa", "normal stress by Nicot (eq. 13)", compression, {}},
      {"kinetic_shear_stress", "tau_k", "Pa", "shear stress of the fluctuating velocities (eq. 14)", shear, {}},
      {"kinetic_normal_stress", "sigma_k", "Pa", "normal stress of the fluctuating velocities (eq. 14)", compression,
       {}},
  };
  return series;
}

ShearTestRecord run_shear_test(DemSample& sample, const ShearTest& test, const RowObserver& observe,
                               ShearTestRecord previous) {
  ShearTestRecord record = std::move(previous);
  // The present step of a sample may be longer, when it was restored.
  const double time_step = test.adaptive ? test.adaptive->smallest : sample.settings().time_step;
  const std::vector<std::int64_t> kept = test.row_steps(time_step), fixed = test.measured_steps(time_step);
  std::size_t k = record.rows.rows(), m = record.measured.rows();
  if (k > kept.size() || m > fixed.size())
    throw std::invalid_argument(
        fmt::format("an element test of {} rows, {} of them measured, cannot continue from {} and "
                    "{}",
                    kept.size(), fixed.size(), k, m));
  const auto bears_the_end = [&] {
    return m > 0 && record.measured.last("normal_stress") >= test.end_normal_stress;
  };
  std::int64_t done = std::max(k > 0 ? kept[k - 1] : 0, m > 0 ? fixed[m - 1] : 0);
  sample.start_linear_at_first_strain();  // the row before the first strain shows the sample at rest
  while ((k < kept.size() || m < fixed.size()) && !bears_the_end()) {
    const bool keep = k < kept.size() && (m == fixed.size() || kept[k] <= fixed[m]);
    const bool measure = m < fixed.size() && (k == kept.size() || fixed[m] <= kept[k]);
    const std::int64_t at = keep ? kept[k] : fixed[m];
    if (at > done) strain_by(sample, test, at - done, time_step);
    done = at;
    const Assembly assembly = sample.assembly();
    const double time = static_cast<double>(at) * time_step;
    const auto values = row(sample, assembly, test.shear_rate, test.shear_rate * time);
    if (measure) record.measured.append_row(time, values);
    if (keep) record.rows.append_row(time, values);
    m += measure ? 1 : 0;
    k += keep ? 1 : 0;
    if (keep && observe) observe(done, assembly, record);
  }
  return record;
}

}  // namespace flowslide
