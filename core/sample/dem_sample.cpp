// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/dem_sample.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>
#include <utility>

#include "grains/bulk_mean_stress.hpp"
#include "grains/require.hpp"
#include "grains/time_step_share.hpp"
#include "sample/health.hpp"
#include "sample/stable_time_step.hpp"

namespace flowslide {
namespace {

constexpr std::array stress_parts{std::pair{"normal_stress", &CellStress::normal},
                                  std::pair{"shear_stress", &CellStress::shear},
                                  std::pair{"transverse_stress", &CellStress::transverse},
                                  std::pair{"lateral_stress_x", &CellStress::lateral_x},
                                  std::pair{"lateral_stress_y", &CellStress::lateral_y}};

/// Tolerance for the stress of a prepared sample, relative to its normal stress. Another number of ranks sums in
/// another order, with other rounding.
constexpr double rounding_of_sums = 1e-9;

void add(std::map<std::string, double>& numbers, const std::string& prefix, const CellStress& stress) {
  for (const auto& [name, part] : stress_parts) numbers[prefix + name] = stress.*part;
}

CellStress stress_in(const SampleState& state, const std::string& prefix) {
  CellStress stress;
  for (const auto& [name, part] : stress_parts) stress.*part = state.number(prefix + name);
  return stress;
}

/// Whether the time step of the settings is stable for these contacts.
bool is_stable(const Assembly& assembly, const EngineSettings& settings) {
  return time_step_share(assembly, settings.material, settings.time_step) < 1.0;
}

/// Throws std::invalid_argument if the pointer is empty.
Engine& engine_at(const std::unique_ptr<Engine>& engine) {
  if (engine) return *engine;
  throw std::invalid_argument("the sample has got an empty pointer in place of an engine, perhaps because another "
                              "sample has taken the engine over; make an engine for each sample");
}

void require_finite_rates(const LocalRun& run) {
  for (const auto& [name, rate] :
       {std::pair{"shear", run.rate.shear}, std::pair{"compression", run.rate.compression}})
    require(std::isfinite(rate), fmt::format("{} rate of a run", name), rate, "any finite number, 1/s",
            "Check the strain that the caller passes.");
}

/// Returns the assembly. Throws std::invalid_argument without grains, for arrays that differ in length, and for a
/// contact of grains that are not there or not in order.
const Assembly& checked(const Assembly& assembly) {
  const std::size_t n = assembly.size();
  const auto refuse = [](const std::string& finding) {
    throw std::invalid_argument("the assembly of a sample has " + finding +
                                "; use the one that prepare_sample or a state has, unchanged");
  };
  if (n == 0) refuse("no grains");
  if (assembly.role.size() != n) refuse(fmt::format("{} grains, but {} roles", n, assembly.role.size()));
  for (const auto& [name, array] :
       {std::pair{"positions", &assembly.position}, std::pair{"velocities", &assembly.velocity},
        std::pair{"spins", &assembly.spin}, std::pair{"forces", &assembly.force},
        std::pair{"torques", &assembly.torque}})
    if (array->size() != n) refuse(fmt::format("{} grains, but {} {}", n, array->size(), name));
  for (const ContactHistory& contact : assembly.contacts)
    if (contact.first >= contact.second || contact.second >= n)
      refuse(fmt::format("a contact of the grains {} and {}; allowed: first < second < {}", contact.first,
                         contact.second, n));
  return assembly;
}

/// In what the prepared sample of `state` differs from one of `grains` grains under the stress `prepared`; empty if it
/// is the same.
std::string difference(const SampleState& state, std::size_t grains, const CellStress& prepared) {
  const CellStress of_state = stress_in(state, "prepared_");
  const std::size_t grains_of_state = state.grains ? state.grains->size() : 0;
  if (grains_of_state != grains)
    return fmt::format("it has {} grains, and this sample has {}", grains_of_state, grains);
  for (const auto& [name, part] : stress_parts)
    if (!(std::abs(of_state.*part - prepared.*part) <= rounding_of_sums * std::abs(prepared.normal)))
      return fmt::format("its prepared_{} is {:.10g} Pa, and that of this sample is {:.10g} Pa", name, of_state.*part,
                         prepared.*part);
  return "";
}

}  // namespace

DemSample::DemSample(std::unique_ptr<Engine> engine, const Assembly& assembly, const EngineSettings& settings,
                     StrainHeight strain_height)
    : DemSample(engine_at(engine), assembly, settings, strain_height) {
  owned_ = std::move(engine);
}

DemSample::DemSample(Engine& engine, const Assembly& assembly, const EngineSettings& settings,
                     StrainHeight strain_height)
    : engine_(engine),
      grains_(checked(assembly).size()),
      solid_volume_(assembly.solid_volume()),
      smallest_radius_(assembly.smallest_radius()) {
  if (strain_height == StrainHeight::between_layers) rigid_ = layer_thickness(assembly);
  for (const Role layer : {Role::bottom_layer, Role::top_layer})
    if (const bool glued = std::find(assembly.role.begin(), assembly.role.end(), layer) != assembly.role.end();
        glued == assembly.cell.periodic[2])
      throw std::invalid_argument(glued ? "the sample has a glued layer in a cell that is periodic along z, which is "
                                          "sheared across its faces; make z rigid, or all grains mobile"
                                        : "the sample has no glued layers, which shear it; prepare it with "
                                          "prepare_sample");
  validate_time_step(settings.time_step, smallest_radius_, settings.material);
  validate_fields(settings);
  engine_.load(assembly, settings);
  stress_ = prepared_ = engine_.cell_stress();
  inspect_time_step();
}

void DemSample::inspect_time_step() {
  since_inspection_ = 0;
  check_contact_time_step(engine_.save(), settings().material, settings().time_step);
}

void DemSample::start_linear_velocity_field(double shear_rate) {
  Assembly assembly = engine_.save();
  Cell& cell = assembly.cell;
  const double at_rest = cell.periodic[2] ? 0.5 * (cell.lower.z() + cell.upper.z()) : cell.lower.z() + rigid_.bottom;
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile) {
      assembly.velocity[i].x() += shear_rate * (assembly.position[i].z() - at_rest);
      assembly.spin[i].y() += 0.5 * shear_rate;
    }
  if (cell.periodic[2]) cell.shear_velocity += shear_rate * cell.height();
  engine_.load(assembly, engine_.settings());
}

CellStress DemSample::strain(const LocalRun& run) {
  const std::clock_t start = std::clock();
  validate(run);
  require_finite_rates(run);
  set_time_step(run.time_step);
  if (steps_ == 0 && linear_at_first_strain_) start_linear_velocity_field(run.rate.shear);
  const double height = engine_.cell().height() - rigid_.bottom - rigid_.top;
  BoundaryMotion motion;
  motion.top_velocity = {run.rate.shear * height, 0.0, -run.rate.compression * height};
  engine_.move(motion);
  engine_.run(run.steps);
  if (run.measured) {
    stress_ = engine_.cell_stress();
    check_exchange(engine_, stress_, grains_);
  }
  shear_strain_ += run.rate.shear * run.duration();
  time_ += run.duration();
  steps_ += run.steps;
  since_inspection_ += run.steps;
  if (since_inspection_ >= time_step_interval) inspect_time_step();
  clock_ticks_ += std::clock() - start;
  return stress_;
}

void DemSample::set_time_step(double time_step) {
  EngineSettings settings = engine_.settings();
  if (time_step == settings.time_step) return;
  if (!(time_step > 0.0 && time_step <= stable_time_step_))
    validate_time_step(time_step, smallest_radius_, settings.material);
  settings.time_step = time_step;
  engine_.set(settings);
}

double DemSample::stable_time_step() {
  return stable_time_step_ = flowslide::stable_time_step(engine_.save(), settings().material, settings().time_step);
}

double DemSample::mean_stress() const {
  const Assembly grains = assembly();
  const Material& material = settings().material;
  return bulk_mean_stress(grains, evaluate_contact_forces(grains, material, settings().time_step), material);
}

double DemSample::void_ratio() const { return engine_.cell().volume() / solid_volume_ - 1.0; }

SampleState DemSample::state() const {
  SampleState state;
  state.grains = engine_.save();
  state.numbers = {{"shear_strain", shear_strain_},
                   {"time", time_},
                   {"steps", static_cast<double>(steps_)},
                   {"time_step", engine_.settings().time_step},
                   {"stable_time_step", stable_time_step_},
                   {"processor_seconds", processor_seconds()}};
  add(state.numbers, "", stress_);
  add(state.numbers, "prepared_", prepared_);
  return state;
}

void DemSample::restore(const SampleState& state) {
  if (const std::string other = difference(state, grains_, prepared_); !other.empty())
    throw std::invalid_argument("the state is that of another sample: " + other +
                                "; restore the state into a sample of the same prepared assembly, material and kind of "
                                "engine");
  checked(*state.grains);
  EngineSettings settings = engine_.settings();
  settings.time_step = state.number("time_step");
  const bool is_long = settings.time_step > longest_time_step(smallest_radius_, settings.material);
  if (!(is_long && is_stable(*state.grains, settings)))
    validate_time_step(settings.time_step, smallest_radius_, settings.material);
  const double shear_strain = state.number("shear_strain"), time = state.number("time");
  const double processor_seconds = state.number("processor_seconds");
  const std::int64_t steps = state.count("steps");
  const double stable_time_step = state.number("stable_time_step");
  const CellStress stress = stress_in(state, "");
  engine_.load(*state.grains, settings);
  stable_time_step_ = stable_time_step;
  shear_strain_ = shear_strain;
  time_ = time;
  steps_ = steps;
  constexpr double a_century = 3.2e9;  // s; no run takes longer
  clock_ticks_ = static_cast<std::clock_t>(std::clamp(processor_seconds, 0.0, a_century) * CLOCKS_PER_SEC);
  stress_ = stress;  // before its first step an engine may round the stress differently
}

Assembly DemSample::assembly() const {
  Assembly assembly = engine_.save();
  check_assembly(assembly);
  return assembly;
}

}  // namespace flowslide
