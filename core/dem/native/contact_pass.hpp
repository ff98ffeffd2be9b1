// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>

#include "dem/native/body.hpp"

namespace flowslide::native {

/// Contacts that are worked on at once.
inline constexpr int tile_size = 64;

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
  std::size_t count;  ///< a multiple of the tile size
  const std::uint32_t *first, *second;
  const std::uint8_t* image;                   ///< which of `image_shift` brings the second next to the first
  const double (*image_shift)[4];              ///< m; shape (27, 4), the last is 0; aligned to 32 bytes
  const double *first_radius, *second_radius;  ///< m
  const Real *effective_radius, *root_effective_mass, *root_rolling_inertia;
  Real *spring[3], *rolling_torque[3];  ///< histories, advanced by the pass
};

/// Which parts of the law a scene needs.
enum class LawVariant { frictionless, sliding, sliding_and_rolling };

/// Adds the contact forces of all pairs to `loads` and advances the histories. If `virial` is not null, adds to its row
/// of each pair's first grain the pair's l_x f_x and l_y f_y (N m), l = x_1 - x_2 and f on the first.
template <typename Real>
using ContactPass = void (*)(LawVariant variant, const LawConstants<Real>& constants, const PairView<Real>& pairs,
                             const Body<Real>* bodies, Load<Real>* loads, double (*virial)[2]);

}  // namespace flowslide::native
