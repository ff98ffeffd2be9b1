// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/native_engine.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <thread>
#include <type_traits>

#include "dem/source_hashes.hpp"
#include "dem/stress_sums.hpp"
#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"

namespace flowslide {
namespace {

using native::Body;
using native::GrainRange;

/// Number of grains from which several threads pay. For smaller samples one run per core is more efficient.
constexpr std::size_t grains_for_threads = 10'000;

bool mobile(Role role) { return role == Role::mobile; }

/// Moves a grain to its image in the cell.
void fold(const Cell& cell, Body<double>& body) {
  for (int axis = 2; axis >= 0; --axis) {  // z first, because in a sheared cell folding along z changes x
    if (!cell.periodic[axis]) continue;
    const double length = cell.lengths()[axis];
    const double periods = std::floor((body.position[axis] - cell.lower[axis]) / length);
    body.position[axis] -= length * periods;
    if (axis < 2 || periods == 0.0) continue;
    body.position[0] -= periods * cell.shear_offset;
    body.velocity[0] -= periods * cell.shear_velocity;
  }
}

/// The cell with its shear offset reduced to at most half a period.
Cell with_reduced_offset(Cell cell) {
  if (cell.shear_offset != 0.0) cell.shear_offset = std::remainder(cell.shear_offset, cell.lengths().x());
  return cell;
}

/// Throws EngineError for sheared faces unless the shear is along x, and x and z are periodic.
void require_shear_along_periods(const Cell& cell, const Vector3& sliding) {
  if (sliding.y() == 0.0 && (sliding.x() == 0.0 || (cell.periodic[0] && cell.periodic[2]))) return;
  throw EngineError(fmt::format("the faces of the cell along z slide by {} m/s along x and {} m/s along y; they do so "
                                "along x alone, in a cell that is periodic along x and z: make it so, or glue layers",
                                sliding.x(), sliding.y()));
}

template <typename Load>
Vector3 force_of(const Load& load) {
  return {load.force[0], load.force[1], load.force[2]};
}
template <typename Load>
Vector3 torque_of(const Load& load) {
  return {load.torque[0], load.torque[1], load.torque[2]};
}

/// Appends two grains that never touch, for the padding of the pair list.
void pad(std::vector<Body<double>>& bodies, std::size_t n) {
  bodies[n + 1].position[0] = 1.0;
  for (std::size_t i : {n, n + 1}) {
    bodies[i].radius = 1e-3;
    bodies[i].mass = bodies[i].inertia = 1.0;
  }
}

}  // namespace

template <typename Real>
NativeEngine<Real>::NativeEngine(const NativeOptions& options) : options_(options) {
  if (options.threads < 0)
    throw EngineError(fmt::format("the native engine cannot use {} threads; allowed: 1 and more, or 0 to let it choose",
                                  options.threads));
  if (!(options.first_allowance >= 0.0) || !std::isfinite(options.first_allowance))
    throw EngineError(fmt::format("the first allowance of the native engine is {} smallest diameters; it must be a "
                                  "number from 0", options.first_allowance));
  if (options_.instruction_set.empty()) options_.instruction_set = native::instruction_sets().back();
}

template <typename Real>
NativeEngine<Real>::~NativeEngine() = default;

template <typename Real>
void NativeEngine<Real>::take_grains(const Assembly& assembly, const Cell& cell) {
  const std::size_t n = assembly.size();
  grains_.role = assembly.role;
  glued_.clear();
  grains_.top_layer.clear();
  grains_.bodies.assign(n + 2, Body<double>{});
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    Body<double>& body = grains_.bodies[i];
    Vector3::Map(body.position) = assembly.position[i];
    Vector3::Map(body.velocity) = assembly.velocity[i];
    fold(cell, body);
    Vector3::Map(body.spin) = assembly.spin[i];
    body.radius = assembly.radius[i];
    body.mass = sphere_mass(body.radius, settings_.material);
    body.inertia = sphere_inertia(body.radius, settings_.material);
    largest = std::max(largest, body.radius);
    if (!mobile(grains_.role[i])) glued_.push_back(static_cast<std::uint32_t>(i));
    if (grains_.role[i] == Role::top_layer) grains_.top_layer.push_back(static_cast<std::uint32_t>(i));
  }
  pad(grains_.bodies, n);
  const std::size_t blocks = (n + native::block_size - 1) / native::block_size;
  grains_.moments.assign(blocks, {});
  grains_.across.assign(blocks, {});
  grains_.largest_diameter = 2.0 * largest;
  grains_.smallest_diameter = 2.0 * assembly.smallest_radius();
}

/// Divides the grains into ranges of whole blocks.
template <typename Real>
std::vector<GrainRange> NativeEngine<Real>::ranges(int threads) const {
  const std::size_t n = grains_.role.size(), blocks = grains_.moments.size();
  std::vector<GrainRange> parts;
  for (std::size_t t = 0, count = static_cast<std::size_t>(threads); t < count; ++t)
    parts.push_back({blocks * t / count * native::block_size,
                     std::min(n, blocks * (t + 1) / count * native::block_size)});
  return parts;
}

template <typename Real>
void NativeEngine<Real>::start_workers(const Cell& cell) {
  const std::size_t n = grains_.role.size();
  int threads = options_.threads;
  if (threads == 0) threads = n < grains_for_threads ? 1 : static_cast<int>(std::thread::hardware_concurrency());
  threads = std::clamp(threads, 1, std::max(1, static_cast<int>(grains_.moments.size())));
  if (!team_ || team_->size() != threads) team_ = std::make_unique<native::ThreadTeam>(threads);
  grains_.fill_buffers(static_cast<std::size_t>(threads));
  const native::Passes<Real> passes = native::passes<Real>(options_.instruction_set);
  workers_.clear();
  for (const GrainRange& range : ranges(threads))
    workers_.emplace_back(range, grains_, native::Boundaries(cell, settings_, range),
                          options_.first_allowance * grains_.smallest_diameter, passes);
}

template <typename Real>
void NativeEngine<Real>::load(const Assembly& assembly, const EngineSettings& settings) {
  settings_ = settings;
  motion_ = {};
  half_step_ = false;
  require_shear_along_periods(assembly.cell, assembly.cell.shear_velocity * Vector3::UnitX());
  const Cell cell = with_reduced_offset(assembly.cell);
  take_grains(assembly, cell);
  const double least_period = 2.0 * native::Worker<Real>::longest_reach(grains_);
  for (int axis = 0; axis < 3; ++axis)
    if (assembly.cell.periodic[axis] && assembly.cell.lengths()[axis] < least_period)
      throw EngineError(fmt::format("the cell is {} m long along periodic axis {}; a grain would meet two images of "
                                    "another: at least {} m are needed", assembly.cell.lengths()[axis], axis,
                                    least_period));
  start_workers(cell);
  prepare_law();
  take_loads(assembly);
  sum_up();
  if (const auto inside = count_grains(); inside != assembly.size())
    throw EngineError(fmt::format("{} of {} grains lie outside the cell; every centre must be inside its planes",
                                  assembly.size() - inside, assembly.size()));
  for (native::Worker<Real>& worker : workers_) {
    worker.rebuild(0);
    worker.list().set_histories(assembly.contacts);
  }
  take_last_step(assembly);
}

template <typename Real>
void NativeEngine<Real>::take_loads(const Assembly& assembly) {
  for (native::Worker<Real>& worker : workers_) {
    for (std::size_t i = worker.range().begin; i < worker.range().end; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        worker.loads()[i].force[axis] = static_cast<Real>(assembly.force[i][axis]);
        worker.loads()[i].torque[axis] = static_cast<Real>(assembly.torque[i][axis]);
      }
    worker.measure(worker.range(), 0);
  }
}

/// Computes the sums over pairs across the faces of the cell and over boundaries in the last step, so that the stress
/// is defined before the next step.
template <typename Real>
void NativeEngine<Real>::take_last_step(const Assembly& assembly) {
  const ContactForces forces = evaluate_contact_forces(assembly, settings_.material, settings_.time_step);
  for (const Contact& contact : forces.contacts) {
    const auto at = [&](std::uint32_t i) { return Vector3::Map(grains_.bodies[i].position); };
    const Vector3 shift = at(contact.first) - at(contact.second) - contact.branch, &force = contact.force.on_first;
    native::AcrossFaces& across = grains_.across[contact.first / native::block_size];
    const native::AcrossFaces more{shift.x() * force.x(), shift.y() * force.y(), shift.z() * force.x(),
                                   shift.z() * force.y(), shift.z() * force.z()};
    for (std::size_t k = 0; k < more.size(); ++k) across[k] += more[k];
  }
  // Planes and drag used the velocities of the half step.
  const std::vector<Body<double>> whole_step = grains_.bodies;
  for (std::size_t i = 0; i < assembly.size(); ++i)
    Vector3::Map(grains_.bodies[i].velocity) -= grains_.kick[i] * assembly.force[i];
  sum_up();
  grains_.bodies = whole_step;
}

template <typename Real>
void NativeEngine<Real>::prepare_law() {
  law_is_new_ = true;
  grains_.time_step = settings_.time_step;
  grains_.law = native::law_constants<Real>(settings_.material, settings_.time_step);
  const std::size_t n = grains_.role.size();
  grains_.kick.resize(n);
  grains_.twist.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const bool moves = mobile(grains_.role[i]);
    grains_.kick[i] = moves ? 0.5 * settings_.time_step / grains_.bodies[i].mass : 0.0;
    grains_.twist[i] = moves ? 0.5 * settings_.time_step / grains_.bodies[i].inertia : 0.0;
  }
}

template <typename Real>
void NativeEngine<Real>::set(const EngineSettings& settings) {
  // Grains and pairs store their masses, and pairs the constants of their law.
  if (settings.material.density != settings_.material.density ||
      settings.material.contact_law != settings_.material.contact_law) {
    const BoundaryMotion motion = motion_;
    load(save(), settings);
    move(motion);
    return;
  }
  finish_step();
  settings_ = settings;
  for (native::Worker<Real>& worker : workers_) worker.boundaries().set(settings);
  prepare_law();
}

template <typename Real>
void NativeEngine<Real>::move(const BoundaryMotion& motion) {
  motion_ = motion;
  if (cell().periodic[2]) slide_faces(motion.top_velocity - motion.bottom_velocity);
  for (native::Worker<Real>& worker : workers_) worker.boundaries().move(motion);
  for (const std::uint32_t i : glued_) {
    Body<double>& body = grains_.bodies[i];
    Vector3::Map(body.velocity) = grains_.role[i] == Role::top_layer ? motion.top_velocity : motion.bottom_velocity;
    Vector3::Map(body.spin).setZero();
  }
}

/// Adds the change of the linear velocity field to the grains.
template <typename Real>
void NativeEngine<Real>::slide_faces(const Vector3& sliding) {
  const Cell cell = this->cell();
  require_shear_along_periods(cell, sliding);
  const double change = (sliding.x() - cell.shear_velocity) / cell.height();
  if (change == 0.0) return;
  finish_step();  // so that a run that continues from a saved state adds in the same order
  const double middle = 0.5 * (cell.lower.z() + cell.upper.z());
  for (std::size_t i = 0; i < grains_.role.size(); ++i)
    if (mobile(grains_.role[i]))
      grains_.bodies[i].velocity[0] += change * (grains_.bodies[i].position[2] - middle);
}

template <typename Real>
void NativeEngine<Real>::run(std::int64_t steps) {
  if (steps <= 0) return;
  team_->run([this, steps](int number) {  // the first begin includes the end of the last step of the previous run
    native::Worker<Real>& worker = workers_[static_cast<std::size_t>(number)];
    if (law_is_new_) worker.list().forget(grains_.law.variant);
    int buffer = 1;
    worker.begin(!half_step_, buffer);
    for (std::int64_t left = steps; left > 1; --left, buffer = 1 - buffer) {
      team_->barrier();
      worker.update_list(workers_, buffer);
      worker.evaluate_and_begin(buffer);
    }
    team_->barrier();
    worker.update_list(workers_, buffer);
    worker.evaluate(buffer);
  });
  grains_.end_run(static_cast<int>(steps % 2));
  half_step_ = true;
  law_is_new_ = false;
  sum_up();
}

template <typename Real>
void NativeEngine<Real>::finish_step() {
  if (!half_step_) return;
  for (native::Worker<Real>& worker : workers_) worker.end(grains_.bodies);
  half_step_ = false;
}

template <typename Real>
void NativeEngine<Real>::sum_up() {
  native::Moments moments;
  for (const native::Moments& block : grains_.moments) moments += block;
  inside_ = moments.inside;
  sums_ = {};
  sums_.mobile_height_times_force = Vector3::Map(moments.height_times_force);
  sums_.mobile_moment = Vector3::Map(moments.moment);
  for (const native::Worker<Real>& worker : workers_) worker.add_boundary_forces(sums_);
  native::AcrossFaces across{};
  for (const native::AcrossFaces& block : grains_.across)
    for (std::size_t k = 0; k < across.size(); ++k) across[k] += block[k];
  sums_.pair_virial_x = sums_.mobile_moment.x() - across[0];
  sums_.pair_virial_y = sums_.mobile_moment.y() - across[1];
  sums_.pair_virial_z = sums_.mobile_height_times_force - Vector3(across[2], across[3], across[4]);
  sums_.top_force.z() += sums_.upper_plane.z();
}

template <typename Real>
CellStress NativeEngine<Real>::cell_stress() const {
  return stress_of(sums_, cell());
}

template <typename Real>
Cell NativeEngine<Real>::cell() const {
  return workers_.at(0).boundaries().cell();
}

/// The grains with the velocities of the last evaluation of forces.
template <typename Real>
std::vector<Body<Real>> NativeEngine<Real>::at_half_step() const {
  std::vector<Body<Real>> rounded;
  for (const Body<double>& body : grains_.bodies) rounded.push_back(native::in_precision<Real>(body));
  if (half_step_) return rounded;
  for (const native::Worker<Real>& worker : workers_)
    for (std::size_t i = worker.range().begin; i < worker.range().end; ++i)
      for (int axis = 0; axis < 3; ++axis) {
        const Body<double>& body = grains_.bodies[i];
        const native::Load<Real>& load = worker.loads()[i];
        rounded[i].velocity[axis] = static_cast<Real>(body.velocity[axis] - grains_.kick[i] * load.force[axis]);
        rounded[i].spin[axis] = static_cast<Real>(body.spin[axis] - grains_.twist[i] * load.torque[axis]);
      }
  return rounded;
}

template <typename Real>
Assembly NativeEngine<Real>::save() const {
  Assembly assembly;
  assembly.cell = cell();
  assembly.resize(grains_.role.size());
  std::vector<Body<double>> bodies = grains_.bodies;
  const std::vector<Body<Real>> half_step = at_half_step();
  for (const native::Worker<Real>& worker : workers_) {
    if (half_step_) worker.end(bodies);
    for (std::size_t i = worker.range().begin; i < worker.range().end; ++i) {
      const Body<double>& body = bodies[i];
      assembly.position[i] = Vector3::Map(body.position);
      assembly.velocity[i] = Vector3::Map(body.velocity);
      assembly.spin[i] = Vector3::Map(body.spin);
      assembly.force[i] = force_of(worker.loads()[i]);
      assembly.torque[i] = torque_of(worker.loads()[i]);
      assembly.radius[i] = body.radius;
      assembly.role[i] = grains_.role[i];
    }
    worker.add_histories(half_step, assembly.contacts);
  }
  return assembly;
}

template <typename Real>
std::string NativeEngine<Real>::name() const {
  return std::is_same_v<Real, float> ? "native-mixed" : "native";
}

template <typename Real>
std::string NativeEngine<Real>::version() const {
  return fmt::format("{} ({}, law in {})", FLOWSLIDE_VERSION, source_hashes::native,
                     std::is_same_v<Real, float> ? "float" : "double");
}

template class NativeEngine<double>;
template class NativeEngine<float>;

}  // namespace flowslide
