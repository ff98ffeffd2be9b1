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

void Boundaries::move(const BoundaryMotion& motion) {
  motion_ = motion;
  if (cell_.periodic[2]) cell_.shear_velocity = motion.top_velocity.x() - motion.bottom_velocity.x();
}

void Boundaries::advance() {
  const double step = settings_.time_step;
  lower_before_ = cell_.lower.z();
  height_before_ = cell_.height();
  cell_.lower.z() += step * motion_.bottom_velocity.z();
  cell_.upper.z() += step * motion_.top_velocity.z();
  for (int axis = 0; axis < 2; ++axis) {
    const double factor = 1.0 - rates(motion_)[axis] * step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);
    if (factor == 1.0) continue;
    cell_.lower[axis] = centre + factor * (cell_.lower[axis] - centre);
    cell_.upper[axis] = centre + factor * (cell_.upper[axis] - centre);
    if (axis == 0) cell_.shear_offset *= factor;
  }
  if (!cell_.periodic[2]) return;
  cell_.shear_offset += step * cell_.shear_velocity;
  const double periods = std::round(cell_.shear_offset / cell_.lengths().x());
  renumbers_ = periods != 0.0;
  if (renumbers_) cell_.shear_offset -= periods * cell_.lengths().x();
}

bool Boundaries::moves_faces() const {
  return cell_.periodic[2] && (motion_.bottom_velocity.z() != 0.0 || motion_.top_velocity.z() != 0.0);
}

bool Boundaries::carries() const {
  return (cell_.periodic[0] && motion_.compression_rate_x != 0.0) ||
         (cell_.periodic[1] && motion_.compression_rate_y != 0.0) || moves_faces();
}

bool Boundaries::compresses() const {
  return motion_.compression_rate_x != 0.0 || motion_.compression_rate_y != 0.0 || moves_faces();
}

void Boundaries::carry(std::vector<Body<double>>& bodies) const {
  for (int axis = 0; axis < 2; ++axis) {
    if (!cell_.periodic[axis]) continue;
    const double factor = 1.0 - rates(motion_)[axis] * settings_.time_step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);  // not changed by `advance`
    for (std::size_t i = range_.begin; i < range_.end; ++i)
      bodies[i].position[axis] = centre + factor * (bodies[i].position[axis] - centre);
  }
  if (!moves_faces()) return;
  const double factor = cell_.height() / height_before_;
  for (std::size_t i = range_.begin; i < range_.end; ++i)
    bodies[i].position[2] = cell_.lower.z() + factor * (bodies[i].position[2] - lower_before_);
}

void Boundaries::find_near(const std::vector<Body<double>>& bodies, const std::vector<Role>& role, double skin) {
  near_.clear();
  for (std::size_t i = range_.begin; i < range_.end; ++i) {
    if (role[i] != Role::mobile) continue;
    const Body<double>& body = bodies[i];
    const double reach = body.radius + skin;
    for (std::uint8_t axis = 0; axis < 3; ++axis) {
      if (cell_.periodic[axis]) continue;
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
void Boundaries::push(const GrainRange& part, const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
                      std::vector<Load<Real>>& loads) const {
  auto near = std::partition_point(near_.begin(), near_.end(), [&](const Near& n) { return n.grain < part.begin; });
  for (; near != near_.end() && near->grain < part.end; ++near) {
    Real& force = loads[near->grain].force[near->axis];
    force = static_cast<Real>(force + push_of(*near, bodies[near->grain]));
  }
  if (settings_.drag == 0.0) return;
  const UniformFlow flow = drag_flow(settings_.drag_reference, cell_, motion_);
  for (std::size_t i = part.begin; i < part.end; ++i) {
    if (role[i] != Role::mobile) continue;
    const Vector3 drag = drag_on(bodies[i], flow);
    for (int axis = 0; axis < 3; ++axis) loads[i].force[axis] = static_cast<Real>(loads[i].force[axis] + drag[axis]);
  }
}

Vector3 Boundaries::drag_on(const Body<double>& body, const UniformFlow& flow) const {
  return -settings_.drag * (Vector3::Map(body.velocity) - flow.at(Vector3::Map(body.position)));
}

void Boundaries::remove_drag_moments(const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
                                     StressSums& sums) const {
  if (settings_.drag == 0.0) return;
  const UniformFlow flow = drag_flow(settings_.drag_reference, cell_, motion_);
  for (std::size_t i = range_.begin; i < range_.end; ++i) {
    if (role[i] != Role::mobile) continue;
    const Vector3 drag = drag_on(bodies[i], flow);
    const Vector3 arm = Vector3::Map(bodies[i].position) - cell_.lower;
    sums.mobile_height_times_force -= arm.z() * drag;
    sums.mobile_moment -= arm.cwiseProduct(drag);
  }
}

template void Boundaries::push(const GrainRange&, const std::vector<Body<double>>&, const std::vector<Role>&,
                               std::vector<Load<double>>&) const;
template void Boundaries::push(const GrainRange&, const std::vector<Body<double>>&, const std::vector<Role>&,
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
  if (moves_faces()) speed += reach * std::abs(motion_.top_velocity.z() - motion_.bottom_velocity.z()) / cell_.height();
  return speed;
}

double Boundaries::side_speed() const {
  double speed = 0.0;
  for (int axis = 0; axis < 2; ++axis)
    if (!cell_.periodic[axis]) speed = std::max(speed, 0.5 * std::abs(rates(motion_)[axis]) * cell_.lengths()[axis]);
  return speed;
}

MeanFlow Boundaries::mean_flow() const {
  const UniformFlow uniform = uniform_flow(cell_, motion_);
  MeanFlow flow{};
  Vector3::Map(flow.base) = uniform.base;
  Vector3::Map(flow.slope) = uniform.slope;
  flow.origin = uniform.origin;
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
