// SPDX-License-Identifier: GPL-2.0-or-later
#include "jam.hpp"

#include <algorithm>
#include <cmath>

namespace flowslide {
namespace {

/// The strain from which tau exceeds `level` (Pa) in all rows to the end; infinite if it does not, or not for long.
double strain_above(const Series& rows, double level, bool lasts) {
  const std::vector<double>&strain = rows.column("shear_strain").values, &shear = rows.column("shear_stress").values;
  std::size_t row = rows.rows();
  while (row > 0 && shear[row - 1] > level) --row;
  const bool above = row < rows.rows() && (lasts || strain.back() - strain[row] >= lasting_strain);
  return above ? strain[row] : std::numeric_limits<double>::infinity();
}

}  // namespace

Jam jam_of(const Series& rows, double initial_normal_stress, bool lasts) {
  const std::vector<double>&strain = rows.column("shear_strain").values, &shear = rows.column("shear_stress").values;
  const std::vector<double>& normal = rows.column("normal_stress").values;
  Jam jam;
  const auto liquefied = std::find_if(normal.begin(), normal.end(),
                                      [&](double stress) { return stress < 0.01 * initial_normal_stress; });
  if (liquefied != normal.end()) jam.liquefied_strain = strain[static_cast<std::size_t>(liquefied - normal.begin())];
  jam.strain_1 = strain_above(rows, 0.01 * initial_normal_stress, lasts);
  jam.strain_10 = strain_above(rows, 0.1 * initial_normal_stress, lasts);
  for (std::size_t row = 0; row < rows.rows(); ++row)
    if (strain[row] > jam.liquefied_strain && strain[row] < jam.strain_10)
      jam.largest_burst = std::max(jam.largest_burst, shear[row]);
  return jam;
}

std::vector<Metric> metrics_of(const Jam& jam, double initial_normal_stress) {
  std::vector<Metric> metrics{
      {"jams", jam.jams() ? 1.0 : 0.0, "1", "1: tau exceeds 10 % of sigma_0 from some strain to the end"},
      {"liquefied_strain", jam.liquefied_strain, "1", "first strain with sigma below 1 % of sigma_0"},
      {"strain_above_1", jam.strain_1, "1", "strain from which tau exceeds 1 % of sigma_0 to the end"},
      {"strain_above_10", jam.strain_10, "1", "strain from which tau exceeds 10 % of sigma_0 to the end"}};
  if (jam.liquefies())
    metrics.push_back({"largest_burst", jam.largest_burst / initial_normal_stress, "1",
                       "largest tau over sigma_0 after liquefaction and before the sample jams"});
  std::erase_if(metrics, [](const Metric& metric) { return !std::isfinite(metric.value); });
  return metrics;
}

}  // namespace flowslide
