// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"

namespace flowslide::testing {

/// n^3 spheres of diameter 1 m, their centres `spacing` (m) apart and half of that from the boundaries of the cell.
inline Assembly cubic_lattice(int n, double spacing, bool periodic) {
  Assembly assembly;
  assembly.resize(static_cast<std::size_t>(n) * n * n);
  assembly.cell.upper = Vector3::Constant(n * spacing);
  assembly.cell.periodic = {periodic, periodic, periodic};
  for (int i = 0; i < n * n * n; ++i) {
    assembly.radius[i] = 0.5;
    assembly.position[i] = spacing * Vector3(i % n + 0.5, i / n % n + 0.5, i / n / n + 0.5);
  }
  return assembly;
}

}  // namespace flowslide::testing
