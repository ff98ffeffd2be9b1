// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/boundaries.hpp"

#include <cmath>

#include "grains/contact_law.hpp"

namespace flowslide::native {

void Boundaries::move(const BoundaryMotion& motion, std::vector<Body>& bodies, const std::vector<Role>& role) {
  motion_ = motion;
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] == Role::mobile) continue;
    Vector3::Map(bodies[i].velocity) = role[i] == Role::top_layer ? motion.top_velocity : motion.bottom_velocity;
    Vector3::Map(bodies[i].spin).setZero();
  }
}

void Boundaries::advance(std::vector<Body>& bodies, std::size_t grains) {
  const double step = settings_.time_step;
  cell_.lower.z() += step * motion_.bottom_velocity.z();
  cell_.upper.z() += step * motion_.top_velocity.z();
  const std::array<double, 2> rate{motion_.compression_rate_x, motion_.compression_rate_y};
  for (int axis = 0; axis < 2; ++axis) {
    if (rate[axis] == 0.0) continue;
    const double factor = 1.0 - rate[axis] * step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);
    cell_.lower[axis] = centre + factor * (cell_.lower[axis] - centre);
    cell_.upper[axis] = centre + factor * (cell_.upper[axis] - centre);
    if (!cell_.periodic[axis]) continue;
    for (std::size_t i = 0; i < grains; ++i)
      bodies[i].position[axis] = centre + factor * (bodies[i].position[axis] - centre);
  }
}

void Boundaries::push(const std::vector<Body>& bodies, const std::vector<Role>& role, std::vector<Load>& loads) {
  const double step_x = 0.5 * motion_.compression_rate_x * cell_.lengths().x();
  const double step_y = 0.5 * motion_.compression_rate_y * cell_.lengths().y();
  const Vector3 lower_velocity(step_x, step_y, motion_.bottom_velocity.z());
  const Vector3 upper_velocity(-step_x, -step_y, motion_.top_velocity.z());
  upper_plane_.setZero();
  for (int axis = 0; axis < 3; ++axis) {
    if (cell_.periodic[axis]) continue;
    for (std::size_t i = 0; i < role.size(); ++i) {
      const Body& body = bodies[i];
      const double below = body.radius - (body.position[axis] - cell_.lower[axis]);
      const double above = body.radius - (cell_.upper[axis] - body.position[axis]);
      if ((below <= 0.0 && above <= 0.0) || role[i] != Role::mobile) continue;
      if (below > 0.0)
        loads[i].force[axis] += plane_normal_force(settings_.material, body.radius, body.mass, below,
                                                   lower_velocity[axis] - body.velocity[axis]);
      if (above > 0.0) {
        const double force = plane_normal_force(settings_.material, body.radius, body.mass, above,
                                                body.velocity[axis] - upper_velocity[axis]);
        loads[i].force[axis] -= force;
        upper_plane_[axis] -= force;
      }
    }
  }
  drag_height_times_force_.setZero();
  drag_moment_.setZero();
  if (settings_.drag == 0.0) return;
  for (std::size_t i = 0; i < role.size(); ++i) {
    if (role[i] != Role::mobile) continue;
    const Vector3 resistance = -settings_.drag * Vector3::Map(bodies[i].velocity);
    const Vector3 position = Vector3::Map(bodies[i].position) - cell_.lower;
    Vector3::Map(loads[i].force) += resistance;
    drag_height_times_force_ += position.z() * resistance;
    drag_moment_ += position.cwiseProduct(resistance);
  }
}

double Boundaries::mean_flow_speed(double reach) const {
  const Vector3 lengths = cell_.lengths();
  return reach * ((motion_.top_velocity - motion_.bottom_velocity).norm() / lengths.z() +
                  std::abs(motion_.compression_rate_x) + std::abs(motion_.compression_rate_y));
}

MeanFlow Boundaries::mean_flow() const {
  MeanFlow flow{};
  Vector3::Map(flow.base) = motion_.bottom_velocity;
  Vector3::Map(flow.slope) = (motion_.top_velocity - motion_.bottom_velocity) / cell_.height();
  flow.origin = cell_.lower.z();
  return flow;
}

}  // namespace flowslide::native
