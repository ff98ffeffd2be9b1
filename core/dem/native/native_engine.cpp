// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/native_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dem/stress_sums.hpp"
#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"

namespace flowslide {
namespace {

using native::Body;
using native::Load;

/// What the list reaches beyond touching, as shares of the smallest diameter. A small skin leaves few open pairs in the
/// list, a large one lasts longer; the engine looks for the balance, and no result depends on it.
constexpr double smallest_skin = 0.002, largest_skin = 0.1;
/// Steps that a list should last: fewer, and the skin grows; more, and it shrinks.
constexpr std::int64_t shortest_age = 40, longest_age = 160;

bool mobile(Role role) { return role == Role::mobile; }

Vector3 folded(const Cell& cell, Vector3 position) {
  for (int axis = 0; axis < 3; ++axis)
    if (cell.periodic[axis])
      position[axis] -= cell.lengths()[axis] * std::floor((position[axis] - cell.lower[axis]) / cell.lengths()[axis]);
  return position;
}

}  // namespace

NativeEngine::NativeEngine(double first_skin)
    : first_skin_(first_skin), contact_pass_(native::contact_pass()), motion_pass_(native::motion_pass()) {}
NativeEngine::~NativeEngine() = default;

void NativeEngine::load(const Assembly& assembly, const EngineSettings& settings) {
  settings_ = settings;
  role_ = assembly.role;
  const std::size_t n = assembly.size();
  bodies_.assign(n + 2, Body{});
  loads_.assign(n + 2, Load{});
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    Body& body = bodies_[i];
    Vector3::Map(body.position) = folded(assembly.cell, assembly.position[i]);
    Vector3::Map(body.velocity) = assembly.velocity[i];
    Vector3::Map(body.spin) = assembly.spin[i];
    body.radius = assembly.radius[i];
    body.mass = sphere_mass(body.radius, settings.material);
    body.inertia = 0.4 * body.mass * body.radius * body.radius;
    Vector3::Map(loads_[i].force) = assembly.force[i];
    Vector3::Map(loads_[i].torque) = assembly.torque[i];
    largest = std::max(largest, body.radius);
  }
  bodies_[n + 1].position[0] = 1.0;  // the pair that pads tiles never touches
  for (Body* pad : {&bodies_[n], &bodies_[n + 1]}) {
    pad->radius = 1e-3;
    pad->mass = pad->inertia = 1.0;
  }
  boundaries_ = std::make_unique<native::Boundaries>(assembly.cell, settings);
  list_ = std::make_unique<native::PairList>();
  largest_diameter_ = 2.0 * largest;
  smallest_diameter_ = 2.0 * assembly.smallest_radius();
  skin_ = first_skin_ * smallest_diameter_;
  list_age_ = 0;
  const double least_period = 2.0 * (largest_diameter_ + largest_skin * smallest_diameter_);
  for (int axis = 0; axis < 3; ++axis)
    if (assembly.cell.periodic[axis] && assembly.cell.lengths()[axis] < least_period)
      throw EngineError(fmt::format("the cell is {} m long along periodic axis {}; a grain would meet two images of "
                                    "another: at least {} m are needed", assembly.cell.lengths()[axis], axis,
                                    least_period));
  prepare_law();
  if (const auto inside = count_grains(); inside != n)
    throw EngineError(fmt::format("{} of {} grains lie outside the cell; every centre must be inside its planes",
                                  n - inside, n));
  rebuild();
  list_->set_histories(assembly.contacts);
  // The sums that the last step left, for a stress before the first step.
  virial_[0] = virial_[1] = 0.0;
  const ContactForces forces = evaluate_contact_forces(assembly, settings.material, settings.time_step);
  for (const Contact& contact : forces.contacts)
    for (int axis = 0; axis < 2; ++axis) virial_[axis] += contact.branch[axis] * contact.force.on_first[axis];
  // Planes and drag see the velocities of the half step.
  std::vector<Body> half = bodies_;
  for (std::size_t i = 0; i < n; ++i) Vector3::Map(half[i].velocity) -= kick_[i] * assembly.force[i];
  std::vector<Load> nowhere(n + 2, Load{});
  boundaries_->push(half, role_, nowhere);
}

void NativeEngine::prepare_law() {
  const Material& m = settings_.material;
  const PairConstants pair = pair_constants(m, 1.0, 1.0);  // moduli and damping do not depend on the radii
  const double dashpot = -2.0 * std::sqrt(5.0 / 6.0) * pair.damping;
  law_ = {.normal_stiffness = 4.0 / 3.0 * pair.effective_modulus,
          .normal_damping = dashpot * std::sqrt(2.0 * pair.effective_modulus),
          .tangential_stiffness = 8.0 * pair.effective_shear_modulus,
          .tangential_damping = dashpot * std::sqrt(8.0 * pair.effective_shear_modulus),
          .sliding_friction = m.sliding_friction,
          .rolling_friction = m.rolling_friction,
          .rolling_stiffness = m.rolling_stiffness * m.rolling_friction * m.rolling_friction,
          .rolling_damping = 2.0 * m.rolling_viscous_damping,
          .time_step = settings_.time_step};
  kick_.resize(role_.size());
  twist_.resize(role_.size());
  for (std::size_t i = 0; i < role_.size(); ++i) {
    kick_[i] = mobile(role_[i]) ? 0.5 * settings_.time_step / bodies_[i].mass : 0.0;
    twist_[i] = mobile(role_[i]) ? 0.5 * settings_.time_step / bodies_[i].inertia : 0.0;
  }
  variant_ = m.rolling_friction > 0.0   ? native::LawVariant::sliding_and_rolling
             : m.sliding_friction > 0.0 ? native::LawVariant::sliding
                                        : native::LawVariant::frictionless;
}

void NativeEngine::fold() {
  // At every step, not when the list is built: a folded coordinate rounds differently.
  const Cell& cell = boundaries_->cell();
  for (std::size_t i = 0; i < role_.size(); ++i)
    for (int axis = 0; axis < 3; ++axis) {
      double& x = bodies_[i].position[axis];
      const bool below = x < cell.lower[axis], above = x >= cell.upper[axis];
      if ((!below && !above) || !cell.periodic[axis] || !std::isfinite(x)) continue;  // count_grains sees a lost grain
      const int periods = below ? 1 : -1;
      x += periods * cell.lengths()[axis];
      list_->carry(static_cast<std::uint32_t>(i), axis, periods);
    }
}

void NativeEngine::rebuild() {
  const Cell& cell = boundaries_->cell();
  if (list_age_ > 0) {  // not the first
    if (list_age_ < shortest_age) skin_ = std::min(1.5 * skin_, largest_skin * smallest_diameter_);
    if (list_age_ > longest_age) skin_ = std::max(0.8 * skin_, smallest_skin * smallest_diameter_);
  }
  list_->build(cell, bodies_, role_, skin_);
  skin_left_ = skin_;
  list_age_ = 0;
}

void NativeEngine::set(const EngineSettings& settings) {
  settings_ = settings;
  boundaries_->set(settings);
  prepare_law();
}

void NativeEngine::move(const BoundaryMotion& motion) { boundaries_->move(motion, bodies_, role_); }

void NativeEngine::move_grains(native::MotionPart part) {
  const double squared = motion_pass_(part, role_.size(), settings_.time_step, kick_.data(), twist_.data(),
                                      boundaries_->mean_flow(), bodies_.data(), loads_.data());
  if (part == native::MotionPart::end) return;
  boundaries_->advance(bodies_, role_.size());
  // Two neighbours approach by at most twice the fastest fluctuation and what the mean flow does over their distance.
  const double approach = 2.0 * std::sqrt(squared) + boundaries_->mean_flow_speed(largest_diameter_ + skin_);
  skin_left_ -= settings_.time_step * approach;
  ++list_age_;
  fold();
  if (!(skin_left_ > 0.0)) rebuild();
}

void NativeEngine::evaluate_forces(bool last) {
  virial_[0] = virial_[1] = 0.0;
  contact_pass_(variant_, law_, list_->view(boundaries_->cell()), bodies_.data(), loads_.data(),
                last ? virial_ : nullptr);
  boundaries_->push(bodies_, role_, loads_);
}

void NativeEngine::run(std::int64_t steps) {
  for (std::int64_t s = 0; s < steps; ++s) {
    move_grains(s == 0 ? native::MotionPart::begin : native::MotionPart::end_and_begin);
    evaluate_forces(s + 1 == steps);
  }
  if (steps > 0) move_grains(native::MotionPart::end);
}

CellStress NativeEngine::cell_stress() const {
  const Vector3 lower = boundaries_->cell().lower;
  StressSums sums;
  for (std::size_t i = 0; i < role_.size(); ++i) {
    const auto force = Vector3::Map(loads_[i].force);
    if (role_[i] == Role::top_layer) sums.top_force -= force;
    if (!mobile(role_[i])) continue;
    const Vector3 position = Vector3::Map(bodies_[i].position) - lower;
    sums.mobile_height_times_force += position.z() * force;
    sums.mobile_moment += position.cwiseProduct(force);
  }
  sums.mobile_height_times_force -= boundaries_->drag_height_times_force();
  sums.mobile_moment -= boundaries_->drag_moment();
  sums.top_force.z() += boundaries_->upper_plane().z();
  sums.upper_plane = boundaries_->upper_plane();
  sums.pair_virial_x = virial_[0];
  sums.pair_virial_y = virial_[1];
  return stress_of(sums, boundaries_->cell());
}

Cell NativeEngine::cell() const { return boundaries_->cell(); }

std::uint64_t NativeEngine::count_grains() const {
  const Cell& cell = boundaries_->cell();
  std::uint64_t inside = 0;
  for (std::size_t i = 0; i < role_.size(); ++i) {
    bool in = true;
    for (int axis = 0; axis < 3; ++axis) {
      const double x = bodies_[i].position[axis];
      in = in && (cell.periodic[axis] ? std::isfinite(x) : x >= cell.lower[axis] && x <= cell.upper[axis]);
    }
    inside += in;
  }
  return inside;
}

Assembly NativeEngine::save() const {
  Assembly assembly;
  assembly.cell = boundaries_->cell();
  assembly.resize(role_.size());
  for (std::size_t i = 0; i < role_.size(); ++i) {
    assembly.position[i] = Vector3::Map(bodies_[i].position);
    assembly.velocity[i] = Vector3::Map(bodies_[i].velocity);
    assembly.spin[i] = Vector3::Map(bodies_[i].spin);
    assembly.force[i] = Vector3::Map(loads_[i].force);
    assembly.torque[i] = Vector3::Map(loads_[i].torque);
    assembly.radius[i] = bodies_[i].radius;
    assembly.role[i] = role_[i];
  }
  assembly.contacts = list_->histories(bodies_);
  return assembly;
}

std::string NativeEngine::version() const { return FLOWSLIDE_VERSION; }

}  // namespace flowslide
