// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_law.hpp"

namespace flowslide {
namespace {

/// v_t = v - (v.n) n - (c_1 w_1 + c_2 w_2) x n, m/s.
Vector3 sliding_velocity(const ContactKinematics& motion, double lever_first, double lever_second) {
  const Vector3& n = motion.normal;
  const Vector3 v = motion.relative_velocity - motion.relative_velocity.dot(n) * n;
  return v - (lever_first * motion.spin_first + lever_second * motion.spin_second).cross(n);
}

/// F_n, N, at the separation velocity v_n (m/s). Not a number stays what it is.
double normal_force_of(const laws::NormalForceLimit& limit, const laws::ContactStiffness& stiffness, double overlap,
                       double separation_velocity) {
  const double force = stiffness.normal * overlap - stiffness.normal_damping * separation_velocity;
  return limit.normal_force_limited && force < 0.0 ? 0.0 : force;
}

ContactForce evaluate(const Material& material, laws::PlainContact contact, const ContactHistories& histories) {
  const ContactKinematics& motion = contact.motion;
  const Vector3& n = motion.normal;
  const double lever_first = contact.pair.radius_first - 0.5 * motion.overlap;
  const double lever_second = contact.pair.radius_second - 0.5 * motion.overlap;
  contact.stiffness = contact_stiffness(material, contact.pair, motion.overlap);
  contact.normal_force =
      normal_force_of(material, contact.stiffness, motion.overlap, motion.relative_velocity.dot(n));
  const Vector3 velocity = sliding_velocity(motion, lever_first, lever_second);
  return visit_law(material.contact_law, [&]<typename Law>(Law) {
    const auto tangential = Law::Tangential::evaluate(material, contact, velocity, histories.tangential_spring);
    const auto rolling = Law::Rolling::evaluate(material, contact, histories.rolling_torque);
    const Vector3 arm = n.cross(tangential.value);
    ContactForce result;
    result.on_first = contact.normal_force * n + tangential.value;
    result.torque_on_first = -lever_first * arm - rolling.value;
    result.torque_on_second = -lever_second * arm + rolling.value;
    result.tangential_spring = tangential.history;
    result.rolling_torque = rolling.history;
    result.normal = contact.normal_force;
    result.sliding = tangential.capped;
    result.rolling = rolling.capped;
    return result;
  });
}

}  // namespace

laws::ContactStiffness contact_stiffness(const Material& material, const PairConstants& pair, double overlap) {
  return visit_law(material.contact_law,
                   [&]<typename Law>(Law) { return Law::Normal::stiffness(material, pair, overlap); });
}

double normal_force(const Material& material, const PairConstants& pair, double overlap, double separation_velocity) {
  return normal_force_of(material, contact_stiffness(material, pair, overlap), overlap, separation_velocity);
}

ContactForce step_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                          const ContactHistories& histories, double time_step) {
  return evaluate(material, {.pair = pair, .motion = motion, .time_step = time_step, .advance = true}, histories);
}

ContactForce stored_contact(const Material& material, const PairConstants& pair, const ContactKinematics& motion,
                            const ContactHistories& histories) {
  return evaluate(material, {.pair = pair, .motion = motion, .advance = false}, histories);
}

double plane_normal_force(const Material& material, double radius, double mass, double overlap,
                          double approach_velocity) {
  PairConstants plane = plane_constants(material, radius);
  plane.effective_mass = mass;
  return normal_force(material, plane, overlap, -approach_velocity);
}

}  // namespace flowslide
