// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/health.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "grains/contact_law.hpp"
#include "grains/measures.hpp"
#include "grains/time_step_share.hpp"
#include "sample/failure.hpp"

namespace flowslide {

double longest_time_step(double smallest_radius, const Material& material) {
  return largest_share_of_rayleigh_time * rayleigh_time(smallest_radius, material);
}

void validate_time_step(double time_step, double smallest_radius, const Material& material) {
  const double limit = longest_time_step(smallest_radius, material);
  if (time_step > 0.0 && time_step <= limit) return;
  throw std::invalid_argument(fmt::format(
      "a DEM time step of {} s is not possible: it must be positive and at most {:.3g} s, which is {} of the Rayleigh "
      "time of the smallest grain; choose a smaller step, or larger or softer grains",
      time_step, limit, largest_share_of_rayleigh_time));
}

void check_exchange(const Engine& engine, const CellStress& stress, std::uint64_t expected_grains) {
  if (const std::uint64_t grains = engine.count_grains(); grains != expected_grains)
    throw NumericalFailure(fmt::format(
        "{} of {} grains are outside the cell or lost: the time step {} s is too large for the speed of the "
        "grains; use a smaller time step or a slower rate",
        expected_grains - grains, expected_grains, engine.settings().time_step));
  if (!std::isfinite(stress.normal + stress.shear + stress.lateral_x + stress.lateral_y))
    throw NumericalFailure(fmt::format("the stress is not finite (sigma = {} Pa, tau = {} Pa) at the time step {} s; "
                                       "use a smaller time step", stress.normal, stress.shear,
                                       engine.settings().time_step));
}

void check_assembly(const Assembly& assembly) {
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (!assembly.position[i].allFinite() || !assembly.velocity[i].allFinite() || !assembly.spin[i].allFinite())
      throw NumericalFailure(fmt::format("grain {} has a position or velocity that is not finite", i));
  for (const ContactHistory& contact : assembly.contacts) {
    const double first = assembly.radius[contact.first], second = assembly.radius[contact.second];
    const Vector3 branch = assembly.cell.nearest_image(assembly.position[contact.first] -
                                                       assembly.position[contact.second]);
    const double overlap = (first + second - branch.norm()) / (2.0 * std::min(first, second));
    if (overlap > largest_overlap)
      throw NumericalFailure(fmt::format(
          "grains {} and {} overlap by {:.3g} of the smaller diameter, more than the {} that spheres may: the stress "
          "is too high for this Young's modulus, or the time step is too large",
          contact.first, contact.second, overlap, largest_overlap));
  }
}

void check_contact_time_step(const Assembly& assembly, const Material& material, double time_step) {
  const double share = time_step_share(assembly, material, time_step);
  if (share < 1.0) return;
  throw NumericalFailure(fmt::format(
      "the time step {} s is too long for contacts of the present stiffness: above about {:.2g} s oscillations grow, "
      "and the sample loses stress without any other sign; use a time step of at most {:.2g} s (less if the stress is "
      "still to rise), or softer grains",
      time_step, time_step_at_edge(time_step, share), 0.95 * time_step_at_edge(time_step, share)));
}

double kinetic_number(const Assembly& assembly, const Material& material, double pressure) {
  double energy = 0.0;
  std::size_t mobile = 0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    energy += 0.5 * sphere_mass(assembly.radius[i], material) * assembly.velocity[i].squaredNorm();
    ++mobile;
  }
  if (mobile == 0) return 0.0;
  return energy / (static_cast<double>(mobile) * pressure * std::pow(assembly.mean_diameter(), 3));
}

}  // namespace flowslide
