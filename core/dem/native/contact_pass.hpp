// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

#include "dem/native/body.hpp"

namespace flowslide::native {

/// Contacts that are worked on at once.
inline constexpr int tile_size = 64;

/// Number of the periodic image of a grain that lies x, y, z periods away, each -1, 0 or 1.
constexpr std::uint8_t image_of(int x, int y, int z) {
  return static_cast<std::uint8_t>(((x + 1) * 3 + y + 1) * 3 + z + 1);
}

/// The z of an image's number: -1 below the cell, 1 above.
constexpr int layer_of(std::uint8_t image) { return image % 3 - 1; }

/// Constants of the law that all pairs share, of one material.
template <typename Real>
struct LawConstants {
  Real normal_stiffness;      ///< 4/3 Y*, so that k_n = this sqrt(R* delta)
  Real normal_damping;        ///< -2 sqrt(5/6) beta sqrt(2 Y*), so that gamma_n = this sqrt(m*) (R* delta)^(1/4)
  Real tangential_stiffness;  ///< 8 G*, so that k_t = this sqrt(R* delta)
  Real tangential_damping;    ///< -2 sqrt(5/6) beta sqrt(8 G*)
  Real sliding_friction;      ///< mu
  Real rolling_friction;      ///< mu_r
  Real rolling_stiffness;     ///< factor mu_r^2, so that k_r = this k_n R*^2
  Real rolling_damping;       ///< 2 eta_r mu_r sqrt(factor 4/3 Y*): the dashpot is this sqrt(I_r) R* (R* delta)^(1/4)
  Real time_step;             ///< dt_L, s
};

/// The pairs of the neighbour list, sorted by (first, second), padded to whole tiles with pairs that never touch.
template <typename Real>
struct PairView {
  std::size_t begin, end;  ///< those to work on; multiples of the tile size
  const std::uint32_t *first, *second;
  const std::uint8_t* image;                   ///< which of `image_shift` brings the second next to the first
  const double (*image_shift)[4];              ///< m; shape (27, 4), the last is 0; aligned to 32 bytes
  const double *first_radius, *second_radius;  ///< m
  const Real *effective_radius, *root_effective_mass, *root_rolling_inertia;
  Real *spring[3], *rolling_torque[3];  ///< histories, advanced by the pass
  Real image_velocity = 0;              ///< by how much the image above the cell is faster along x, m/s
};

/// Which parts of the law a scene needs.
enum class LawVariant { frictionless, sliding, sliding_and_rolling };

/// Grains of a block, over which sums for the stress are taken: sums of blocks make the same total for any number of
/// threads.
inline constexpr std::size_t block_size = 64;

/// Sums over pairs of s_x f_x, s_y f_y, s_z f_x, s_z f_y and s_z f_z, N m: s is the image shift of the second grain and
/// f the force on the first. It is what the sum over grains of x f lacks to the sum over pairs of l f.
using AcrossFaces = std::array<double, 5>;

/// Adds the contact forces of the pairs to `loads` and advances the histories. If `across` is not null, adds to its row
/// of the block of each pair's first grain.
template <typename Real>
using ContactPass = void (*)(LawVariant variant, const LawConstants<Real>& constants, const PairView<Real>& pairs,
                             const Body<Real>* bodies, Load<Real>* loads, AcrossFaces* across);

}  // namespace flowslide::native
