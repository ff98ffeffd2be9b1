// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_law.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace flowslide {
namespace {

double square(double x) { return x * x; }

/// gamma = -2 sqrt(5/6) beta sqrt(S m*), kg/s.
double dashpot(const PairConstants& pair, double stiffness) {
  return dashpot_coefficient(pair) * std::sqrt(stiffness * pair.effective_mass);
}

double normal_stiffness(const PairConstants& pair, double overlap) {
  return hertz_coefficient(pair) * std::sqrt(pair.effective_radius * overlap);
}

double tangential_stiffness(const PairConstants& pair, double overlap) {
  return mindlin_coefficient(pair) * std::sqrt(pair.effective_radius * overlap);
}

struct Capped {
  Vector3 value;
  bool reached;
};

/// `value`, scaled to the length `cap` if it is longer. A stored value was scaled in its step: near the cap it counts
/// as capped.
Capped apply_cap(const Vector3& value, double cap, bool stored, Cap known) {
  if (stored && known != Cap::unknown) return {value, known == Cap::reached};
  const double length = value.norm();
  const bool reached = stored ? length >= cap * (1.0 - cap_tolerance) : length > cap;
  if (length <= cap) return {value, reached};
  return {value * (cap / length), reached};
}

/// v_t = v - (v.n) n - (c_1 w_1 + c_2 w_2) x n, m/s.
Vector3 sliding_velocity(const ContactKinematics& motion, double lever_first, double lever_second) {
  const Vector3& n = motion.normal;
  const Vector3 v = motion.relative_velocity - motion.relative_velocity.dot(n) * n;
  return v - (lever_first * motion.spin_first + lever_second * motion.spin_second).cross(n);
}

/// Returns F_t; writes the new spring and `sliding` to `result`.
Vector3 tangential_force(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                         const Vector3& velocity, Vector3 spring, double time_step, bool advance, Cap known,
                         ContactForce& result) {
  const Vector3& n = motion.normal;
  if (advance) {
    spring += velocity * time_step;
    spring -= spring.dot(n) * n;
  }
  const double stiffness = tangential_stiffness(pair, motion.overlap);
  const double cap = material.sliding_friction * std::abs(result.normal);
  const Capped elastic = apply_cap(-stiffness * spring, cap, !advance, known);
  result.sliding = elastic.reached;
  result.tangential_spring = advance && elastic.reached ? Vector3(-elastic.value / stiffness) : spring;
  if (elastic.reached) return elastic.value;
  return elastic.value - dashpot(pair, stiffness) * velocity;
}

/// Returns the torque of the rolling model; its negative acts on the first sphere. Writes the new spring torque and
/// `rolling` to `result`.
Vector3 rolling_torque_of(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                          const Vector3& stored, double time_step, bool advance, Cap known, ContactForce& result) {
  const Vector3 spin = motion.spin_first - motion.spin_second;
  const Vector3 rolling_spin = spin - spin.dot(motion.normal) * motion.normal;
  const double stiffness = material.rolling_stiffness * normal_stiffness(pair, motion.overlap) *
                           square(material.rolling_friction) * square(pair.effective_radius);
  const double cap = material.rolling_friction * std::abs(result.normal) * pair.effective_radius;
  const Vector3 torque = advance ? Vector3(stored + stiffness * time_step * rolling_spin) : stored;
  const Capped elastic = apply_cap(torque, cap, !advance, known);
  result.rolling = elastic.reached;
  result.rolling_torque = advance ? elastic.value : stored;
  if (elastic.reached) return elastic.value;
  const double critical = 2.0 * std::sqrt(pair.rolling_inertia * stiffness);
  return elastic.value + material.rolling_viscous_damping * critical * rolling_spin;
}

}  // namespace

double normal_force(const PairConstants& pair, double overlap, double separation_velocity) {
  const double damping = dashpot(pair, 1.5 * normal_stiffness(pair, overlap));  // S_n = 3/2 k_n
  return normal_stiffness(pair, overlap) * overlap - damping * separation_velocity;
}

ContactForce evaluate_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                              const Vector3& tangential_spring, const Vector3& rolling_torque, double time_step,
                              bool advance_history, Cap spring_cap, Cap torque_cap) {
  const Vector3& n = motion.normal;
  const double lever_first = pair.radius_first - 0.5 * motion.overlap;
  const double lever_second = pair.radius_second - 0.5 * motion.overlap;
  ContactForce result;
  result.normal = normal_force(pair, motion.overlap, motion.relative_velocity.dot(n));
  const Vector3 velocity = sliding_velocity(motion, lever_first, lever_second);
  const Vector3 tangential = tangential_force(material, pair, motion, velocity, tangential_spring, time_step,
                                              advance_history, spring_cap, result);
  const Vector3 rolling =
      rolling_torque_of(material, pair, motion, rolling_torque, time_step, advance_history, torque_cap, result);
  const Vector3 arm = n.cross(tangential);
  result.on_first = result.normal * n + tangential;
  result.torque_on_first = -lever_first * arm - rolling;
  result.torque_on_second = -lever_second * arm + rolling;
  return result;
}

double plane_normal_force(const Material& material, double radius, double mass, double overlap,
                          double approach_velocity) {
  PairConstants plane = plane_constants(material, radius);
  plane.effective_mass = mass;
  return normal_force(plane, overlap, -approach_velocity);
}

}  // namespace flowslide
