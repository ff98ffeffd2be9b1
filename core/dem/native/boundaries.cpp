// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/boundaries.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "grains/contact_law.hpp"

namespace flowslide::native {
namespace {

std::array<double, 3> rates(const BoundaryMotion& motion) {
  return {motion.compression_rate_x, motion.compression_rate_y, 0.0};
}

}  // namespace

void Boundaries::advance() {
  const double step = settings_.time_step;
  cell_.lower.z() += step * motion_.bottom_velocity.z();
  cell_.upper.z() += step * motion_.top_velocity.z();
  for (int axis = 0; axis < 2; ++axis) {
    const double factor = 1.0 - rates(motion_)[axis] * step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);
    if (factor == 1.0) continue;
    cell_.lower[axis] = centre + factor * (cell_.lower[axis] - centre);
    cell_.upper[axis] = centre + factor * (cell_.upper[axis] - centre);
  }
}

bool Boundaries::carries() const {
  return (cell_.periodic[0] && motion_.compression_rate_x != 0.0) ||
         (cell_.periodic[1] && motion_.compression_rate_y != 0.0);
}

void Boundaries::carry(std::vector<Body<double>>& bodies) const {
  for (int axis = 0; axis < 2; ++axis) {
    if (!cell_.periodic[axis]) continue;
    const double factor = 1.0 - rates(motion_)[axis] * settings_.time_step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);  // it does not move
    for (std::size_t i = share_.begin; i < share_.end; ++i)
      bodies[i].position[axis] = centre + factor * (bodies[i].position[axis] - centre);
  }
}

void Boundaries::find_near(const std::vector<Body<double>>& bodies, const std::vector<Role>& role, double skin) {
  near_.clear();
  for (std::uint8_t axis = 0; axis < 3; ++axis) {
    if (cell_.periodic[axis]) continue;
    for (std::size_t i = share_.begin; i < share_.end; ++i) {
      if (role[i] != Role::mobile) continue;
      const Body<double>& body = bodies[i];
      const double reach = body.radius + skin;
      for (const bool upper : {false, true}) {
        const double away = upper ? cell_.upper[axis] - body.position[axis] : body.position[axis] - cell_.lower[axis];
        if (!(away > reach)) near_.push_back({static_cast<std::uint32_t>(i), axis, upper});
      }
    }
  }
}

double Boundaries::push_of(const Near& near, const Body<double>& body) const {
  const int axis = near.axis;
  const double side = near.upper ? -1.0 : 1.0;
  const double plane = near.upper ? cell_.upper[axis] : cell_.lower[axis];
  const double overlap = body.radius - side * (body.position[axis] - plane);
  if (overlap <= 0.0) return 0.0;
  const double ends = 0.5 * rates(motion_)[axis] * cell_.lengths()[axis];
  const double vertical = near.upper ? motion_.top_velocity.z() : motion_.bottom_velocity.z();
  const double plane_velocity = axis == 2 ? vertical : side * ends;
  return side * plane_normal_force(settings_.material, body.radius, body.mass, overlap,
                                   side * (plane_velocity - body.velocity[axis]));
}

template <typename Real>
void Boundaries::push(const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
                      std::vector<Load<Real>>& loads) const {
  for (const Near& near : near_) {
    Real& force = loads[near.grain].force[near.axis];
    force = static_cast<Real>(force + push_of(near, bodies[near.grain]));
  }
  if (settings_.drag == 0.0) return;
  for (std::size_t i = share_.begin; i < share_.end; ++i)
    for (int axis = 0; axis < 3 && role[i] == Role::mobile; ++axis)
      loads[i].force[axis] = static_cast<Real>(loads[i].force[axis] - settings_.drag * bodies[i].velocity[axis]);
}

template void Boundaries::push(const std::vector<Body<double>>&, const std::vector<Role>&,
                               std::vector<Load<double>>&) const;
template void Boundaries::push(const std::vector<Body<double>>&, const std::vector<Role>&,
                               std::vector<Load<float>>&) const;

void Boundaries::add_upper_plane(const std::vector<Body<double>>& bodies, Vector3& force) const {
  for (const Near& near : near_)
    if (near.upper) force[near.axis] += push_of(near, bodies[near.grain]);
}

double Boundaries::mean_flow_speed(double reach) const {
  const MeanFlow flow = mean_flow();
  double speed = reach * Vector3::Map(flow.slope).norm();
  for (int axis = 0; axis < 2; ++axis)
    if (cell_.periodic[axis]) speed += reach * std::abs(rates(motion_)[axis]);
  return speed;
}

double Boundaries::side_speed() const {
  double speed = 0.0;
  for (int axis = 0; axis < 2; ++axis)
    if (!cell_.periodic[axis]) speed = std::max(speed, 0.5 * std::abs(rates(motion_)[axis]) * cell_.lengths()[axis]);
  return speed;
}

MeanFlow Boundaries::mean_flow() const {
  MeanFlow flow{};
  // Nothing flows through a rigid side, and across a periodic face along z the flow would jump.
  for (int axis = 0; axis < 3 && !cell_.periodic[2]; ++axis) {
    if (axis < 2 && !cell_.periodic[axis]) continue;
    flow.base[axis] = motion_.bottom_velocity[axis];
    flow.slope[axis] = (motion_.top_velocity[axis] - motion_.bottom_velocity[axis]) / cell_.height();
  }
  flow.origin = cell_.lower.z();
  return flow;
}

Box Boundaries::periods() const {
  constexpr double far = std::numeric_limits<double>::infinity();
  Box box{{-far, -far, -far, -far}, {far, far, far, far}};
  for (int axis = 0; axis < 3; ++axis)
    if (cell_.periodic[axis]) {
      box.lower[axis] = cell_.lower[axis];
      box.upper[axis] = cell_.upper[axis];
    }
  return box;
}

Box Boundaries::confines() const {
  constexpr double far = std::numeric_limits<double>::max();
  Box box{{-far, -far, -far, -far}, {far, far, far, far}};
  for (int axis = 0; axis < 3; ++axis)
    if (!cell_.periodic[axis]) {
      box.lower[axis] = cell_.lower[axis];
      box.upper[axis] = cell_.upper[axis];
    }
  return box;
}

}  // namespace flowslide::native
