// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiments.hpp"

#include <algorithm>
#include <cmath>

#include "grains/contact_forces.hpp"
#include "grains/measures.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide {
namespace {

double mean(const std::vector<Look>& looks, double from, double CellStress::*part) {
  double sum = 0.0;
  int count = 0;
  for (const Look& look : looks) {
    if (look.strain < from) continue;
    sum += look.stress.*part;
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

/// Energy of a Hertz spring, J: with F = k overlap^(3/2) it is (2/5) F overlap.
double hertz_energy(const PairConstants& pair, double overlap) {
  return 0.4 * 4.0 / 3.0 * pair.effective_modulus * std::sqrt(pair.effective_radius * overlap) * overlap * overlap;
}

}  // namespace

std::vector<Look> shear(const Workshop& workshop, const Assembly& sample, const EngineSettings& settings, double rate,
                        double strain, int looks) {
  const auto engine = workshop.engine();
  DemSample sheared(*engine, sample, settings);
  sheared.start_linear_at_first_strain();
  const double steps = strain / (rate * settings.time_step);
  std::vector<Look> seen;
  std::int64_t done = 0;
  for (int look = 1; look <= looks; ++look) {
    const auto until = static_cast<std::int64_t>(std::llround(steps * look / looks));
    if (until > done) sheared.strain({{rate, 0.0}, until - done, settings.time_step});
    done = until;
    seen.push_back({sheared.shear_strain(), sheared.stress()});
    workshop.border();
  }
  sheared.assembly();  // throws if the last state is not valid
  return seen;
}

Assembly expanded(const Workshop& workshop, double share) {
  constexpr double time_step = 5e-6, rate = 1.0;
  const auto engine = workshop.engine();
  const Assembly loose = workshop.prepared(workshop.suite().loose).assembly;
  DemSample sample(*engine, loose, {workshop.suite().material, time_step, 0.0});
  sample.strain({{0.0, -rate}, std::llround(share / (rate * time_step)), time_step});
  return sample.assembly();
}

double peak_of(const std::vector<Look>& looks) {
  double peak = 0.0;
  for (const Look& look : looks) peak = std::max(peak, look.stress.shear);
  return peak;
}

double mean_shear(const std::vector<Look>& looks, double from) { return mean(looks, from, &CellStress::shear); }
double mean_normal(const std::vector<Look>& looks, double from) { return mean(looks, from, &CellStress::normal); }

double time_step_of(double share, const Assembly& sample, const Material& material) {
  return share * rayleigh_time(sample.smallest_radius(), material);
}

SlideState slide_on_grains(const Workshop& workshop, const Assembly& sample, const SlideSettings& settings,
                           const StopConditions& stop, bool linear_start,
                           const std::function<void(const Slide&)>& observe) {
  const auto engine = workshop.engine();
  DemSample grains(*engine, sample, {workshop.suite().material, settings.passing.time_step, 0.0});
  if (linear_start) grains.start_linear_at_first_strain();
  SlideSettings on_sample = settings;
  on_sample.rate = for_grains(settings.rate, {sample.mean_diameter(), workshop.suite().material.density},
                              initial_normal_stress(settings.slope));
  Slide slide(on_sample, grains);
  validate(stop);
  while (stop_of(slide.state(), stop, settings.time_step) == Stop::not_yet) {
    slide.step();
    if (observe) observe(slide);
    workshop.border();
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
    energy += hertz_energy(pair, contact.overlap) +
              0.5 * stiffness.tangential * contact.force.tangential_spring.squaredNorm();
    if (rolling > 0.0) energy += 0.5 * contact.force.rolling_torque.squaredNorm() / rolling;
  }
  for (const PlaneContact& plane : forces.plane_contacts)
    energy += hertz_energy(plane_constants(material, assembly.radius[plane.grain]), plane.overlap);
  return energy;
}

}  // namespace flowslide
