// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/run_measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "experiment/slide_series.hpp"
#include "grains/measures.hpp"

namespace flowslide {
namespace {

// Widths of the first windows. The metrics of all cases are means over whole multiples of these widths.
constexpr double time_width = 1e-3;          // s
constexpr double strain_width = 1.25e-4;     // gamma
constexpr double displacement_width = 5e-3;  // m

constexpr double steady_from = 0.5;  ///< the lowest sigma is searched up to this shear strain

/// Smallest pressure in an inertial number, which has no value at p = 0. The pressure of a closed-form sample may be
/// zero or negative.
constexpr double least_pressure = 1e-6;  // Pa

/// Margin for the rounding of a clock that is computed as a product, as a fraction of the distance.
constexpr double rounding_of_multiples = 1e-9;

const std::vector<std::string> time_columns{"velocity", "shear_stress", "normal_stress"};
const std::vector<std::string> displacement_columns{"velocity"};
const std::vector<std::string> strain_columns{"velocity",     "shear_stress",    "normal_stress",         "rate_asked",
                                              "rate_applied", "inertial_number", "global_inertial_number"};
constexpr std::size_t without_numbers = 5;  ///< the first strain columns, which are not inertial numbers

WindowRecord windows_of_slide(const std::string& abscissa, const std::vector<std::string>& names, double width) {
  const Series series = slide_series();
  std::vector<Column> columns;
  for (const std::string& name : names) columns.push_back(series.column(name));
  return window_record(series.column(abscissa), columns, width);
}

void raise(StressPeak& peak, double limit, double largest_strain, const StressPeak& now) {
  if (largest_strain <= limit && now.stress > peak.stress) peak = now;
}

}  // namespace

double next_multiple(double value, double distance) {
  return distance * (std::floor(value / distance + rounding_of_multiples) + 1.0 - rounding_of_multiples);
}

double number_at(double rate, double mean_stress, const GrainScale& grains) {
  return inertial_number(rate, grains.mean_diameter, grains.density, std::max(mean_stress, least_pressure));
}

std::vector<Series> RunMeasures::windows() const {
  std::vector<Series> all;
  for (const Series* series : {&over_time, &over_strain, &over_displacement})
    if (!series->columns.empty()) all.push_back(*series);
  return all;
}

ExchangeRecord::ExchangeRecord(const GrainScale& grain_scale, double interval)
    : grains(grain_scale),
      mean_stress_interval(interval),
      over_time(windows_of_slide("time", time_columns, time_width)),
      over_displacement(windows_of_slide("displacement", displacement_columns, displacement_width)) {
  std::vector<std::string> names = strain_columns;
  if (!has_numbers()) names.resize(without_numbers);
  over_strain = windows_of_slide("shear_strain", names, strain_width);
}

bool ExchangeRecord::has_numbers() const { return std::isfinite(mean_stress_interval); }

void ExchangeRecord::take(const Slide& slide) {
  const SlideState& state = slide.state();
  double number = 0.0, applied_number = 0.0;
  if (has_numbers()) {
    if (state.time >= next_mean_stress) {
      mean_stress = slide.sample().mean_stress();
      mean_stress_time = state.time;
      next_mean_stress = next_multiple(state.time, mean_stress_interval);
    }
    number = number_at(state.global_rate, mean_stress, grains);
    applied_number = number_at(state.rate_applied, mean_stress, grains);
  }
  take_peaks(state.time, state.strain.shear, state.stress, number);
  over_time.add(state.time, std::array{state.velocity, state.stress.shear, state.stress.normal});
  over_displacement.add(state.sliding.displacement, std::array{state.velocity});
  if (taken > 1 && state.local_steps == strained_steps) return;
  strained_steps = state.local_steps;
  const std::array at_strain{
      state.velocity, state.stress.shear, state.stress.normal, state.rate_asked, state.rate_applied, applied_number,
      number};
  over_strain.add(state.strain.shear, std::span(at_strain).first(over_strain.means.columns.size()));
}

void ExchangeRecord::take_peaks(double time, double strain, const BasalStress& stress, double number) {
  if (taken++ == 0) {
    largest_strain = strain;
    largest_number = number;
    lowest_normal_stress = stress.normal;
    peak_to_2 = peak_to_5 = {stress.shear, stress.normal, strain, time, number};
    return;
  }
  largest_strain = std::max(largest_strain, strain);
  largest_number = std::max(largest_number, number);
  if (strain <= steady_from) lowest_normal_stress = std::min(lowest_normal_stress, stress.normal);
  const StressPeak now{stress.shear, stress.normal, strain, time, largest_number};
  raise(peak_to_2, 0.02, largest_strain, now);
  raise(peak_to_5, 0.05, largest_strain, now);
}

void ExchangeRecord::restore(const ExchangeRecord& kept) {
  const auto same = [](const WindowRecord& a, const WindowRecord& b) {
    return a.width == b.width && a.means.axis.name == b.means.axis.name &&
           std::equal(a.means.columns.begin(), a.means.columns.end(), b.means.columns.begin(), b.means.columns.end(),
                      [](const Column& one, const Column& other) { return one.name == other.name; });
  };
  if (!same(over_time, kept.over_time) || !same(over_strain, kept.over_strain) ||
      !same(over_displacement, kept.over_displacement))
    throw std::invalid_argument("the means over windows are not of this slide: other columns or widths");
  ExchangeRecord restored = kept;
  restored.grains = grains;
  restored.mean_stress_interval = mean_stress_interval;
  *this = std::move(restored);
}

RunMeasures ExchangeRecord::measures() const {
  return {over_time.series(), over_strain.series(), over_displacement.series(), peak_to_2,
          peak_to_5,          lowest_normal_stress};
}

RunMeasures measures_of_rows(const Series& rows) {
  RunMeasures measures;
  if (rows.has("time")) measures.over_time = windows_of_rows(rows, "time", time_columns, time_width);
  if (rows.has("shear_strain"))
    measures.over_strain = windows_of_rows(rows, "shear_strain", strain_columns, strain_width);
  if (rows.has("displacement"))
    measures.over_displacement = windows_of_rows(rows, "displacement", displacement_columns, displacement_width);
  if (!rows.has("shear_strain") || !rows.has("shear_stress") || !rows.has("normal_stress")) return measures;
  ExchangeRecord record;
  for (std::size_t row = 0; row < rows.rows(); ++row) {
    const auto at = [&](const char* name) { return rows.column(name).values[row]; };
    record.take_peaks(rows.axis.values[row], at("shear_strain"), {at("shear_stress"), at("normal_stress")},
                      rows.has("global_inertial_number") ? at("global_inertial_number") : 0.0);
  }
  measures.peak_to_2 = record.peak_to_2;
  measures.peak_to_5 = record.peak_to_5;
  measures.lowest_normal_stress = record.lowest_normal_stress;
  return measures;
}

}  // namespace flowslide
