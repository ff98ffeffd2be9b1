// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the parts of a contact law read and return in their plain form, which step_contact and stored_contact compose
// (grains/contact_law.hpp).
#pragma once
#include <Eigen/Geometry>
#include <cmath>

#include "grains/cap.hpp"
#include "grains/pair_constants.hpp"
#include "grains/vector.hpp"

namespace flowslide {

/// Motion of a touching pair: velocities at the half step, geometry at the full step.
struct ContactKinematics {
  Vector3 normal = Vector3::UnitX();             ///< n, unit vector from the second centre to the first
  double overlap = 0.0;                          ///< delta = R_1 + R_2 - |x_1 - x_2|, m, >= 0
  Vector3 relative_velocity = Vector3::Zero();   ///< v_1 - v_2 of the centres, m/s
  Vector3 spin_first = Vector3::Zero();          ///< w_1, rad/s
  Vector3 spin_second = Vector3::Zero();         ///< w_2, rad/s
};

/// The history of a part: a vector, and whether it is at its cap.
struct PartHistory {
  Vector3 value = Vector3::Zero();
  Cap cap = Cap::unknown;
};

namespace laws {

/// A list of types: the parameters of a part, the parts, the laws.
template <typename... Items>
struct List {};

/// A parameter as LIGGGHTS takes it: `fix NAME all property/global NAME scalar VALUE`, or one value per pair of types.
enum class PropertyKind { scalar, per_pair };
template <typename Parameters>
struct LiggghtsProperty {
  const char* name;
  PropertyKind kind;
  double Parameters::*value;
};

/// A setting of a model of LIGGGHTS: `NAME on` or `NAME off` in the pair style.
template <typename Parameters>
struct LiggghtsSwitch {
  const char* name;
  bool Parameters::*value;
};

/// Stiffnesses and dashpots of a contact at its present overlap.
struct ContactStiffness {
  double normal = 0.0;              ///< k_n = F_n / delta without dashpot, N/m
  double loading = 0.0;             ///< S_n = dF_n / d delta, N/m
  double tangential = 0.0;          ///< k_t, N/m
  double normal_damping = 0.0;      ///< gamma_n, kg/s
  double tangential_damping = 0.0;  ///< gamma_t, kg/s
};

/// One contact as the tangential and the rolling part read it. `advance` makes one step of `time_step` (s); false
/// evaluates the histories as they were stored at the end of a step.
struct PlainContact {
  const PairConstants& pair;
  const ContactKinematics& motion;
  ContactStiffness stiffness = {};
  double normal_force = 0.0;  ///< F_n, N
  double time_step = 0.0;     ///< s
  bool advance = true;
};

/// Force (N) or torque (N m) of a part, its new history, and whether that is at its cap.
struct PartForce {
  Vector3 value;
  Vector3 history;
  bool capped;
};

/// A stored history counts as capped within this relative distance of its cap. The value is larger than the rounding of
/// the scaling to the cap (about 1e-16, or 1e-7 with the law in float), and smaller than any physical difference.
inline constexpr double cap_tolerance = 1e-6;

struct Capped {
  Vector3 value;
  bool reached;
};

/// `value`, scaled to the length `cap` if it is longer. A stored value was scaled in its step: near the cap it counts
/// as capped, unless `known` states it.
inline Capped apply_cap(const Vector3& value, double cap, bool stored, Cap known) {
  if (stored && known != Cap::unknown) return {value, known == Cap::reached};
  const double length = value.norm();
  const bool reached = stored ? length >= cap * (1.0 - cap_tolerance) : length > cap;
  if (length <= cap) return {value, reached};
  return {value * (cap / length), reached};
}

}  // namespace laws
}  // namespace flowslide
