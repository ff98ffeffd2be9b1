// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "dem/native/body.hpp"
#include "dem/native/law_constants.hpp"

namespace flowslide::native {

/// Number of contacts in a tile, which are computed together.
inline constexpr int tile_size = 64;

/// Number of the periodic image that is shifted by x, y and z periods, each -1, 0 or 1.
constexpr std::uint8_t image_of(int x, int y, int z) {
  return static_cast<std::uint8_t>(((x + 1) * 3 + y + 1) * 3 + z + 1);
}

/// The z of an image number: -1 below the cell, 1 above it.
constexpr int layer_of(std::uint8_t image) { return image % 3 - 1; }

/// The pairs of the pair list, sorted by (first, second), padded to whole tiles with pairs that never touch.
template <typename Real>
struct PairView {
  std::size_t begin, end;  ///< range of pairs to compute; multiples of the tile size
  const std::uint32_t *first, *second;
  const std::uint8_t* image;                   ///< row of `image_shift` that moves the second grain next to the first
  const double (*image_shift)[4];              ///< m; shape (27, 4), the last column is 0; aligned to 32 bytes
  const double *first_radius, *second_radius;  ///< m
  const Real *effective_radius, *root_effective_mass, *root_rolling_inertia;
  const Real* root_scale;  ///< sqrt(s) of a law whose scale is constant for a pair (see grains/laws/lane.hpp)
  Real *spring[3], *rolling_torque[3];  ///< histories, which the pass advances
  Real image_velocity = 0;              ///< velocity of the image above the cell along x relative to the cell, m/s
  /// The second grains of pairs before this one are fetched from memory ahead of use; 0: the grains fit into the cache,
  /// and fetching would only cost time.
  std::size_t fetch_end = 0;
};

/// Distance in pairs by which grains are fetched ahead of use.
inline constexpr std::size_t fetch_distance = 2 * tile_size;

/// Number of grains in a block. Sums for the stress are taken block by block, so that the total has the same bits for
/// any number of threads.
inline constexpr std::size_t block_size = 64;

/// Sums over pairs of s_x f_x, s_y f_y, s_z f_x, s_z f_y and s_z f_z, N m, with the image shift s of the second grain
/// and the force f on the first. The sum over pairs of l f is the sum over grains of x f minus this sum.
using AcrossFaces = std::array<double, 5>;

/// Adds the contact forces of the pairs to `loads` and advances the histories. If `across` is not null, adds the sums
/// of each pair to the row of the block of its first grain.
template <typename Real>
using ContactPass = void (*)(const LawConstants<Real>& constants, const PairView<Real>& pairs,
                             const Body<Real>* bodies, Load<Real>* loads, AcrossFaces* across);

}  // namespace flowslide::native
