// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "grains/assembly.hpp"
#include "grains/fields.hpp"

namespace flowslide {

/// Spheres on a sparse lattice, before any contact (paper, sec. 2.2.1 and stage 1 of the preparation).
struct LatticePacking {
  std::array<int, 3> counts{20, 20, 22};   ///< sites along x, y, z; each >= 3
  double smallest_diameter = 5.0e-3;       ///< D_min, m, > 0
  double largest_diameter = 7.5e-3;        ///< D_max, m, >= D_min
  double spacing = 1.1;                    ///< distance of neighbouring sites over D_max, > 1 + 2 jitter
  double jitter = 0.04;                    ///< largest shift of a centre from its site per axis, over D_max, >= 0
  std::uint64_t seed = 1;                  ///< any value; equal seeds give equal packings on every platform

  static constexpr auto fields() {
    return std::tuple{
        Field{"lattice", &LatticePacking::counts, "1", Bounds::between(3, 1000)},  // the product fits in int
        Field{"smallest_diameter", &LatticePacking::smallest_diameter, "m", Bounds::positive()},
        Field{"largest_diameter", &LatticePacking::largest_diameter, "m", Bounds::positive()},
        Field{"spacing", &LatticePacking::spacing, "1", Bounds::positive()},
        Field{"jitter", &LatticePacking::jitter, "1", Bounds::not_negative()},
        Field{"seed", &LatticePacking::seed}};
  }
};
static_assert(lists_every_member<LatticePacking>());

/// Throws std::invalid_argument if an option is out of the range given at its declaration.
void validate(const LatticePacking& options);

/// nx ny nz mobile spheres at rest in a cell of six rigid planes with its lower corner at the origin; x is the fastest
/// index. No sphere touches another sphere or a plane: sites are `spacing` D_max apart and half of that from the
/// planes, and a centre is at most `jitter` D_max from its site along each axis.
///
/// Diameters are between D_min and D_max. Each interval of diameter has an equal solid volume ("a uniform distribution
/// of particle volumes"): the number density is n(D) ~ D^-3, thus
///   F(D) = (D_min^-2 - D^-2) / (D_min^-2 - D_max^-2),   D(u) = [D_min^-2 - u (D_min^-2 - D_max^-2)]^(-1/2).
/// This interpretation has the number mean 2 D_min D_max / (D_min + D_max) = 6.00 mm of the paper. A sphere volume that
/// is uniform between V_min and V_max would give 6.41 mm. The sampling is stratified: one diameter from each of nx ny
/// nz equal intervals of u, then a random order. The grading therefore hardly differs between seeds, also in small
/// samples. Throws as `validate`.
Assembly lattice_packing(const LatticePacking& options = {});

}  // namespace flowslide
