// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/packing.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "grains/random.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {

void shuffle(std::vector<double>& values, Generator& generator) {
  for (std::size_t left = values.size(); left > 1; --left)
    std::swap(values[left - 1], values[static_cast<std::size_t>(uniform(generator) * static_cast<double>(left))]);
}

/// D(u), m; see draw_diameters.
double diameter_at(double u, const LatticePacking& options) {
  const double most = 1.0 / (options.smallest_diameter * options.smallest_diameter);
  const double least = 1.0 / (options.largest_diameter * options.largest_diameter);
  return 1.0 / std::sqrt(most - u * (most - least));
}

std::vector<double> draw_with(Generator& generator, const LatticePacking& options, std::int64_t count) {
  std::vector<double> diameters;
  diameters.reserve(static_cast<std::size_t>(count));
  for (std::int64_t k = 0; k < count; ++k)
    diameters.push_back(diameter_at((static_cast<double>(k) + uniform(generator)) / static_cast<double>(count),
                                    options));
  shuffle(diameters, generator);
  return diameters;
}

}  // namespace

void validate(const LatticePacking& options) {
  validate_fields(options);
  require(options.largest_diameter >= options.smallest_diameter, "largest_diameter", options.largest_diameter,
          ">= the smallest, " + field_text(options.smallest_diameter) + " m", "Exchange the two?");
  require(options.spacing > 1.0 + 2.0 * options.jitter, "spacing", options.spacing,
          "more than 1 + 2 jitter = " + field_text(1.0 + 2.0 * options.jitter) + " (of the largest diameter)",
          "Raise the spacing or lower the jitter.");
}

Assembly lattice_packing(const LatticePacking& options) {
  validate(options);
  const auto [nx, ny, nz] = options.counts;
  const std::int64_t count = std::int64_t{nx} * ny * nz;
  Generator generator(options.seed);
  const std::vector<double> diameters = draw_with(generator, options, count);
  const double spacing = options.spacing * options.largest_diameter;
  const double jitter = options.jitter * options.largest_diameter;
  Assembly assembly;
  assembly.resize(static_cast<std::size_t>(count));
  assembly.cell.upper = spacing * Vector3(nx, ny, nz);
  for (std::int64_t i = 0; i < count; ++i) {
    const std::int64_t site[3] = {i % nx, i / nx % ny, i / nx / ny};
    assembly.radius[i] = 0.5 * diameters[i];
    for (int axis = 0; axis < 3; ++axis)
      assembly.position[i][axis] =
          (static_cast<double>(site[axis]) + 0.5) * spacing + jitter * (2.0 * uniform(generator) - 1.0);
  }
  return assembly;
}

}  // namespace flowslide
