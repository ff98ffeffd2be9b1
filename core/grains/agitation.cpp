// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/agitation.hpp"

#include <cmath>

#include "grains/random.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {
/// Makes the random sequence independent of that of a packing with the same seed. The value is arbitrary.
constexpr std::uint64_t other_sequence = 0x9e3779b97f4a7c15;
}  // namespace

void agitate(Assembly& assembly, double speed, std::uint64_t seed) {
  require(std::isfinite(speed) && speed >= 0.0, "speed of the mixing", speed, "finite and >= 0 m/s",
          "Use 0 for grains at rest.");
  Generator generator(seed ^ other_sequence);
  Vector3 momentum = Vector3::Zero();
  double mass = 0.0;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (assembly.role[i] != Role::mobile) continue;
    for (int axis = 0; axis < 3; ++axis) assembly.velocity[i][axis] = speed * normal(generator);
    const double volume = assembly.radius[i] * assembly.radius[i] * assembly.radius[i];
    momentum += volume * assembly.velocity[i];
    mass += volume;
  }
  if (mass == 0.0) return;
  const Vector3 mean = momentum / mass;
  for (std::size_t i = 0; i < assembly.size(); ++i)
    if (assembly.role[i] == Role::mobile) assembly.velocity[i] -= mean;
}

}  // namespace flowslide
