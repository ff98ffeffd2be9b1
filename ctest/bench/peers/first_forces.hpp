// SPDX-License-Identifier: GPL-2.0-or-later
// The contact forces of an initial state without tangential and rolling springs, by the law of this project and by
// those of other codes. Other codes start without springs, because their input has none.
#pragma once
#include <filesystem>
#include <vector>

#include "grains/vector.hpp"
#include "peers/peer_sample.hpp"

namespace flowslide {

/// What the law of another code has in the first step where the law "hertz" of this project has something else.
struct FirstStepLaw {
  bool arms_to_surface = false;      ///< the velocity of the surface is that at R, not at R - delta/2
  bool none_beyond_cap = false;      ///< F_t is 0 if the tangential dashpot exceeds mu |F_n|
  bool glued_are_heavy = false;      ///< m* of a pair with a glued grain is the mass of the other grain
  bool attraction_left_out = false;  ///< F_n is at least 0; where it is 0, F_t is 0 as well
  double normal_rate = 0.0;          ///< gamma_n = rate sqrt(R* delta) m*, 1/(m s); 0: as in this project
  double tangential_rate = 0.0;      ///< likewise for gamma_t
};

/// The contact forces on each grain (N, shape (n)) with velocities of the full step, without planes.
std::vector<Vector3> first_forces(const PeerSample& sample, const FirstStepLaw& law);

/// The same from evaluate_contact_forces.
std::vector<Vector3> first_forces_of_this_project(const PeerSample& sample);

/// sigma and tau on horizontal sections, Pa, in the signs of CellStress.
struct SectionStress {
  double normal = 0.0, shear = 0.0;
};
/// The stress from the contact forces on each grain: the z row of bagi_stress in its form without pairs.
SectionStress section_stress(const Assembly& assembly, const std::vector<Vector3>& forces);

/// Reads forces as another code wrote them: lines "id fx fy fz" with ids from 1, in any order; other lines are left
/// out. Throws std::runtime_error if there is not one line for each of `count` grains.
std::vector<Vector3> read_forces(const std::filesystem::path& file, std::size_t count);

/// The largest difference of two sets of forces over the largest force of the second.
double force_error(const std::vector<Vector3>& forces, const std::vector<Vector3>& expected);

}  // namespace flowslide
