// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/steering_fix.hpp"

#include <atom.h>
#include <domain.h>
#include <update.h>

#include <string>

#include "dem/liggghts/commands.hpp"
#include "dem/uniform_flow.hpp"
#include "grains/contact_law.hpp"

namespace flowslide {
namespace {

std::array<char*, 3> fix_arguments() {
  static std::array<std::string, 3> words{"steering", "all", "flowslide/steering"};
  return {words[0].data(), words[1].data(), words[2].data()};
}

}  // namespace

SteeringFix::SteeringFix(LAMMPS_NS::LAMMPS* lammps, const Cell& cell, const EngineSettings& settings)
    : Fix(lammps, 3, fix_arguments().data()), cell_(cell), settings_(settings) {
  box_change_size = 1;  // the neighbour list then also checks the motion of the box
}

int SteeringFix::setmask() { return LAMMPS_NS::FixConst::INITIAL_INTEGRATE | LAMMPS_NS::FixConst::POST_FORCE; }

void SteeringFix::move(const BoundaryMotion& motion) {
  motion_ = motion;
  for (int i = 0; i < atom->nlocal; ++i) {
    const Role role = role_of(atom->type[i]);
    if (role == Role::mobile) continue;
    const Vector3& velocity = role == Role::top_layer ? motion.top_velocity : motion.bottom_velocity;
    Vector3::Map(atom->v[i]) = velocity;
    Vector3::Map(atom->omega[i]).setZero();
  }
}

void SteeringFix::initial_integrate(int) {
  const double step = update->dt;
  carry_layers(step);
  if (motion_.compression_rate_x != 0.0 || motion_.compression_rate_y != 0.0) compress(step);
}

void SteeringFix::carry_layers(double step) {
  for (int i = 0; i < atom->nlocal; ++i)
    if (role_of(atom->type[i]) != Role::mobile) Vector3::Map(atom->x[i]) += step * Vector3::Map(atom->v[i]);
  cell_.lower.z() += step * motion_.bottom_velocity.z();
  cell_.upper.z() += step * motion_.top_velocity.z();
}

void SteeringFix::compress(double step) {
  const std::array<double, 2> rate{motion_.compression_rate_x, motion_.compression_rate_y};
  for (int axis = 0; axis < 2; ++axis) {
    const double factor = 1.0 - rate[axis] * step;
    const double centre = 0.5 * (cell_.lower[axis] + cell_.upper[axis]);
    cell_.lower[axis] = centre + factor * (cell_.lower[axis] - centre);
    cell_.upper[axis] = centre + factor * (cell_.upper[axis] - centre);
    if (!cell_.periodic[axis]) continue;
    for (int i = 0; i < atom->nlocal; ++i) atom->x[i][axis] = centre + factor * (atom->x[i][axis] - centre);
    domain->boxlo[axis] = cell_.lower[axis];
    domain->boxhi[axis] = cell_.upper[axis];
  }
  if (!cell_.periodic[0] && !cell_.periodic[1]) return;
  domain->set_global_box();
  domain->set_local_box();
}

void SteeringFix::post_force(int) {
  push_from_planes();
  drag_height_times_force_.setZero();
  drag_moment_.setZero();
  if (settings_.drag != 0.0) drag_grains();
}

void SteeringFix::push_from_planes() {
  const std::array<double, 3> lower_velocity{
      0.5 * motion_.compression_rate_x * cell_.lengths().x(), 0.5 * motion_.compression_rate_y * cell_.lengths().y(),
      motion_.bottom_velocity.z()};
  const std::array<double, 3> upper_velocity{-lower_velocity[0], -lower_velocity[1], motion_.top_velocity.z()};
  for (int axis = 0; axis < 3; ++axis) {
    upper_plane_[axis] = 0.0;
    if (cell_.periodic[axis]) continue;
    for (int i = 0; i < atom->nlocal; ++i) {
      if (role_of(atom->type[i]) != Role::mobile) continue;
      const double radius = atom->radius[i], position = atom->x[i][axis], velocity = atom->v[i][axis];
      const double below = radius - (position - cell_.lower[axis]);
      if (below > 0.0) {
        const double push = plane_normal_force(settings_.material, radius, atom->rmass[i], below,
                                                lower_velocity[axis] - velocity);
        atom->f[i][axis] += push;
      }
      const double above = radius - (cell_.upper[axis] - position);
      if (above > 0.0) {
        const double push = plane_normal_force(settings_.material, radius, atom->rmass[i], above,
                                                velocity - upper_velocity[axis]);
        atom->f[i][axis] -= push;
        upper_plane_[axis] -= push;
      }
    }
  }
}

void SteeringFix::drag_grains() {
  const UniformFlow flow = drag_flow(settings_.drag_reference, cell_, motion_);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (role_of(atom->type[i]) != Role::mobile) continue;
    const Vector3 resistance = -settings_.drag * (Vector3::Map(atom->v[i]) - flow.at(Vector3::Map(atom->x[i])));
    Vector3::Map(atom->f[i]) += resistance;
    const Vector3 position = Vector3::Map(atom->x[i]) - cell_.lower;
    drag_height_times_force_ += position.z() * resistance;
    drag_moment_ += position.cwiseProduct(resistance);
  }
}

StressSums SteeringFix::sums() const {
  StressSums sums;
  for (int i = 0; i < atom->nlocal; ++i) {
    const auto total_force = Vector3::Map(atom->f[i]);
    const Role role = role_of(atom->type[i]);
    if (role == Role::mobile) {
      const Vector3 from_lower = Vector3::Map(atom->x[i]) - cell_.lower;
      sums.mobile_height_times_force += from_lower.z() * total_force;
      sums.mobile_moment += from_lower.cwiseProduct(total_force);
    }
    if (role == Role::top_layer) sums.top_force -= total_force;
  }
  sums.mobile_height_times_force -= drag_height_times_force_;
  sums.mobile_moment -= drag_moment_;
  sums.top_force.z() += upper_plane_.z();
  sums.upper_plane = upper_plane_;
  return sums;
}

std::uint64_t SteeringFix::grains_inside() const {
  std::uint64_t count = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside = inside && (cell_.periodic[axis] || (atom->x[i][axis] >= cell_.lower[axis] &&
                                                   atom->x[i][axis] <= cell_.upper[axis]));
    count += inside;
  }
  return count;
}

}  // namespace flowslide
