// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiments.hpp"

#include <algorithm>
#include <cmath>

#include "grains/contact_forces.hpp"
#include "grains/contact_law.hpp"
#include "grains/measures.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide {
namespace {

double mean(const std::vector<ShearReading>& readings, double from, double CellStress::*part) {
  double sum = 0.0;
  int count = 0;
  for (const ShearReading& reading : readings) {
    if (reading.strain < from) continue;
    sum += reading.stress.*part;
    ++count;
  }
  return sum / count;
}

double kinetic_energy(const Assembly& assembly, const Material& material) {
  double energy = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    energy += 0.5 * sphere_mass(assembly.radius[i], material) * assembly.velocity[i].squaredNorm() +
              0.5 * sphere_inertia(assembly.radius[i], material) * assembly.spin[i].squaredNorm();
  }
  return energy;
}

/// Energy of a normal spring, J. Its force F = k overlap is a power of the overlap, with the exponent
/// p = d(ln F)/d(ln overlap) = S/k (3/2 for Hertz); the energy is F overlap / (1 + p).
double spring_energy(const Material& material, const PairConstants& pair, double overlap) {
  if (overlap == 0.0) return 0.0;
  const laws::ContactStiffness stiffness = contact_stiffness(material, pair, overlap);
  return stiffness.normal * overlap * overlap / (1.0 + stiffness.loading / stiffness.normal);
}

}  // namespace

std::vector<ShearReading> shear(const SceneContext& context, const Assembly& sample, const EngineSettings& settings,
                                const Shearing& shearing) {
  const auto engine = context.engine();
  DemSample sheared(*engine, sample, settings);
  sheared.start_linear_at_first_strain();
  const double steps = shearing.final_strain / (shearing.rate * settings.time_step);
  std::vector<ShearReading> readings;
  std::int64_t done = 0;
  for (int reading = 1; reading <= shearing.readings; ++reading) {
    const auto until = static_cast<std::int64_t>(std::llround(steps * reading / shearing.readings));
    if (until > done) sheared.strain({{shearing.rate, 0.0}, until - done, settings.time_step});
    done = until;
    readings.push_back({sheared.shear_strain(), sheared.stress()});
    context.stop_if_due();
  }
  sheared.assembly();  // throws if the last state is not valid
  return readings;
}

Assembly expanded(const SceneContext& context, double share) {
  constexpr double time_step = 5e-6, rate = 1.0;
  const auto engine = context.engine();
  const Assembly loose = context.prepared(context.settings().loose).assembly;
  DemSample sample(*engine, loose, {context.settings().material, time_step, 0.0});
  sample.strain({{0.0, -rate}, std::llround(share / (rate * time_step)), time_step});
  return sample.assembly();
}

double peak_of(const std::vector<ShearReading>& readings) {
  double peak = 0.0;
  for (const ShearReading& reading : readings) peak = std::max(peak, reading.stress.shear);
  return peak;
}

double mean_shear(const std::vector<ShearReading>& readings, double from) {
  return mean(readings, from, &CellStress::shear);
}
double mean_normal(const std::vector<ShearReading>& readings, double from) {
  return mean(readings, from, &CellStress::normal);
}

double time_step_of(double share, const Assembly& sample, const Material& material) {
  return share * rayleigh_time(sample.smallest_radius(), material);
}

SlideState run_slide(const SceneContext& context, const Assembly& sample, const GrainSlide& planned) {
  const auto engine = context.engine();
  DemSample grains(*engine, sample, {context.settings().material, planned.settings.passing.time_step, 0.0});
  if (planned.linear_start) grains.start_linear_at_first_strain();
  SlideSettings settings = planned.settings;
  settings.rate = for_grains(settings.rate, {sample.mean_diameter(), context.settings().material.density},
                             initial_normal_stress(settings.slope));
  Slide slide(settings, grains);
  validate(planned.stop);
  while (stop_of(slide.state(), planned.stop, settings.time_step) == Stop::not_yet) {
    slide.step();
    if (planned.observe) planned.observe(slide);
    context.stop_if_due();
  }
  grains.assembly();  // throws if the last state is not valid
  return slide.state();
}

double energy_of(const Assembly& assembly, const Material& material) {
  double energy = kinetic_energy(assembly, material);
  const ContactForces forces = evaluate_contact_forces(assembly, material, 0.0);
  for (const Contact& contact : forces.contacts) {
    const PairConstants pair =
        pair_constants(material, assembly.radius[contact.first], assembly.radius[contact.second]);
    const laws::ContactStiffness stiffness = contact_stiffness(material, pair, contact.overlap);
    const double rolling = visit_law(material.contact_law, [&]<typename Law>(Law) {
      return Law::Rolling::stiffness(material, pair, stiffness.normal);
    });
    energy += spring_energy(material, pair, contact.overlap) +
              0.5 * stiffness.tangential * contact.force.tangential_spring.squaredNorm();
    if (rolling > 0.0) energy += 0.5 * contact.force.rolling_torque.squaredNorm() / rolling;
  }
  for (const PlaneContact& plane : forces.plane_contacts)
    energy += spring_energy(material, plane_constants(material, assembly.radius[plane.grain]), plane.overlap);
  return energy;
}

}  // namespace flowslide
