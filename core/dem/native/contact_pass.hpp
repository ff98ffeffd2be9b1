// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>
#include <cstdint>

namespace flowslide::native {

/// Contacts that are worked on at once.
inline constexpr int tile_size = 64;

/// One grain as the contact pass reads it: what a pair needs stands in three lines of half a cache line.
struct alignas(32) Body {
  double position[3];  ///< m, not folded between two builds of the list
  double radius;       ///< m
  double velocity[3];  ///< m/s, of the half step while forces are evaluated
  double mass;         ///< kg
  double spin[3];      ///< rad/s
  double inertia;      ///< kg m^2
};

/// What acts on a grain.
struct alignas(64) Load {
  double force[3];  ///< N
  double unused0;
  double torque[3];  ///< N m
  double unused1;
};

/// Constants of the law that all pairs share, of one material.
struct LawConstants {
  double normal_stiffness;      ///< 4/3 Y*, so that k_n = this sqrt(R* delta)
  double normal_damping;        ///< -2 sqrt(5/6) beta sqrt(2 Y*), so that gamma_n = this sqrt(m*) (R* delta)^(1/4)
  double tangential_stiffness;  ///< 8 G*, so that k_t = this sqrt(R* delta)
  double tangential_damping;    ///< -2 sqrt(5/6) beta sqrt(8 G*)
  double sliding_friction;      ///< mu
  double rolling_friction;      ///< mu_r
  double rolling_stiffness;     ///< factor mu_r^2, so that k_r = this k_n R*^2
  double rolling_damping;       ///< 2 eta_r, so that the dashpot is this sqrt(I_r k_r)
  double time_step;             ///< dt_L, s
};

/// The pairs of the neighbour list, sorted by (first, second), padded to whole tiles with pairs that never touch.
struct PairView {
  std::size_t count;  ///< a multiple of the tile size
  const std::uint32_t *first, *second;
  const std::uint8_t* image;                   ///< which of `image_shift` brings the second next to the first
  const double (*image_shift)[4];              ///< m; shape (27, 4), the last is unused; aligned to 32 bytes
  const double *first_radius, *second_radius;  ///< m
  const double *effective_radius, *root_effective_mass, *root_rolling_inertia;
  double *spring[3], *rolling_torque[3];  ///< histories, advanced by the pass
};

/// Which parts of the law a scene needs.
enum class LawVariant { frictionless, sliding, sliding_and_rolling };

/// Adds the contact forces of all pairs to `loads` and advances the histories. If `virial` is not null, adds to it the
/// sums over pairs of l_x f_x and l_y f_y (N m), l = x_1 - x_2 and f on the first.
using ContactPass = void (*)(LawVariant variant, const LawConstants& constants, const PairView& pairs,
                             const Body* bodies, Load* loads, double* virial);

/// A linear field of velocities u = base + slope (z - origin), m/s: what the boundaries impose on the whole sample.
struct MeanFlow {
  alignas(32) double base[4];   ///< m/s, the last is 0
  alignas(32) double slope[4];  ///< 1/s, the last is 0
  double origin;                ///< m
};

/// Which half kicks the motion pass does: that of the end of a step, that of the beginning with the drift, or both.
enum class MotionPart { end, begin, end_and_begin };

/// Velocity Verlet over `count` grains: v <- v + dt/2 f/m, x <- x + dt v, spins likewise. `kick` is dt/2 m and `twist`
/// dt/2 I_s of each grain, 0 for glued ones. A part with a beginning clears the loads. Returns the square of the
/// largest |v - u|, m^2/s^2, after a beginning, else 0.
using MotionPass = double (*)(MotionPart part, std::size_t count, double time_step, const double* kick,
                              const double* twist, const MeanFlow& flow, Body* bodies, Load* loads);

/// The pass compiled for the widest vectors that this processor has. All give the same bits.
ContactPass contact_pass();
/// The pass of one instruction set, "baseline", "avx2" or "avx512"; null if the build or the processor lacks it.
ContactPass contact_pass(const char* instruction_set);

MotionPass motion_pass();
MotionPass motion_pass(const char* instruction_set);

}  // namespace flowslide::native
