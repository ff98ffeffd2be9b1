// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "dem/native/passes.hpp"
#include "grains/contact_law.hpp"
#include "support/clustered_cloud.hpp"
#include "support/contact_switches.hpp"

namespace flowslide::native {

constexpr double pass_step = 1e-6;  // s

/// One material for each contact law with each of its switches, and for each variant.
inline std::vector<Material> materials() {
  std::vector<Material> all;
  for (const std::string& name : contact_law_names()) {
    Material m;
    m.contact_law = contact_law_of(name);
    for (const Material& switched : with_all_switches(m)) all.push_back(switched);
    m.rolling_friction = 0.0;
    all.push_back(m);
    m.sliding_friction = 0.0;
    all.push_back(m);
  }
  return all;
}

template <typename Real, std::size_t size>
Vector3 vector_of(const Real (&components)[size]) {
  return {components[0], components[1], components[2]};
}

/// Random pairs, each of two grains of its own, some open, some through a periodic image, with random histories,
/// sticking and sliding.
template <typename Real>
struct RandomPairs {
  explicit RandomPairs(std::uint64_t seed, const Material& m = {}, std::size_t count = 4 * tile_size) : material(m) {
    Dice dice(seed);
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) Vector3::Map(shift[image_of(x, y, z)]) = Vector3(0.1 * x, 0.2 * y, 0.3 * z);
    for (std::size_t p = 0; p < count; ++p) {
      first.push_back(static_cast<std::uint32_t>(2 * p));
      second.push_back(static_cast<std::uint32_t>(2 * p + 1));
      image.push_back(p % 3 == 0 ? static_cast<std::uint8_t>(dice.below(27)) : image_of(0, 0, 0));
      const Body<double> a = grain(dice);
      Body<double> b = grain(dice);
      const Vector3 apart = dice.vector(1.0).normalized() * (a.radius + b.radius) * (1.0 - dice.between(-0.01, 0.02));
      Vector3::Map(b.position) = Vector3::Map(a.position) - apart - Vector3::Map(shift[image[p]]);
      add_constants(pair_constants(m, a.radius, b.radius));
      bodies.push_back(in_precision<Real>(a));
      bodies.push_back(in_precision<Real>(b));
      const Vector3 s = dice.vector(dice.below(2) == 0 ? 1e-8 : 1e-5),
                    t = dice.vector(dice.below(2) == 0 ? 1e-7 : 1e-3);
      for (int axis = 0; axis < 3; ++axis) {
        history[axis].push_back(static_cast<Real>(s[axis]));
        history[axis + 3].push_back(static_cast<Real>(t[axis]));
      }
    }
    loads.resize(bodies.size());
    across.resize((bodies.size() + block_size - 1) / block_size);
  }
  static Body<double> grain(Dice& dice) {
    Body<double> body{};
    body.radius = dice.between(1e-3, 3e-3);
    body.mass = sphere_mass(body.radius, Material{});
    body.inertia = sphere_inertia(body.radius, Material{});
    Vector3::Map(body.velocity) = dice.vector(dice.below(2) == 0 ? 1e-2 : 1.0);
    Vector3::Map(body.spin) = dice.vector(10.0);
    Vector3::Map(body.position) = dice.vector(0.1);
    return body;
  }
  void add_constants(const PairConstants& c) {
    first_radius.push_back(c.radius_first);
    second_radius.push_back(c.radius_second);
    effective_radius.push_back(static_cast<Real>(c.effective_radius));
    root_effective_mass.push_back(static_cast<Real>(std::sqrt(c.effective_mass)));
    root_rolling_inertia.push_back(static_cast<Real>(std::sqrt(c.rolling_inertia)));
    root_scale.push_back(
        static_cast<Real>(constant_root_scale(material.contact_law, c.effective_radius, c.effective_mass)));
  }
  /// Neighbours in the list share their first grain, as in a real one.
  void share_first() {
    for (std::size_t p = 0; p < first.size(); p += 2) {
      for (int axis = 0; axis < 3; ++axis)
        bodies[second[p + 1]].position[axis] +=
            bodies[first[p]].position[axis] - bodies[first[p + 1]].position[axis];
      first[p + 1] = first[p];
      first_radius[p + 1] = first_radius[p];
    }
  }

  PairView<Real> view() {
    PairView<Real> v{0,
                     first.size(),
                     first.data(),
                     second.data(),
                     image.data(),
                     shift,
                     first_radius.data(),
                     second_radius.data(),
                     effective_radius.data(),
                     root_effective_mass.data(),
                     root_rolling_inertia.data(),
                     root_scale.data(),
                     {},
                     {},
                     image_velocity};
    for (int axis = 0; axis < 3; ++axis) {
      v.spring[axis] = history[axis].data();
      v.rolling_torque[axis] = history[axis + 3].data();
    }
    return v;
  }
  void evaluate(const Passes<Real>& passes) {
    passes.contacts(law_constants<Real>(material, pass_step), view(), bodies.data(),
                    loads.data(), across.data());
  }

  /// Separation and overlap as the pass computes them in double, to the bit.
  Vector3 separation(std::size_t p) const {
    return Vector3::Map(bodies[first[p]].position) -
           (Vector3::Map(bodies[second[p]].position) + Vector3::Map(shift[image[p]]));
  }
  double overlap(std::size_t p) const {
    const Vector3 d = separation(p);
    const double squared = std::fma(d.z(), d.z(), std::fma(d.y(), d.y(), d.x() * d.x()));
    return first_radius[p] + second_radius[p] - std::sqrt(squared);
  }
  Vector3 spring(std::size_t p) const { return {history[0][p], history[1][p], history[2][p]}; }
  Vector3 torque(std::size_t p) const { return {history[3][p], history[4][p], history[5][p]}; }
  /// What the law of the grains makes of a pair.
  ContactForce law(std::size_t p) const {
    const Body<Real>&a = bodies[first[p]], &b = bodies[second[p]];
    const ContactKinematics motion{separation(p) / (first_radius[p] + second_radius[p] - overlap(p)), overlap(p),
                                   vector_of(a.velocity) - vector_of(b.velocity) -
                                       double{image_velocity} * layer_of(image[p]) * Vector3::UnitX(),
                                   vector_of(a.spin), vector_of(b.spin)};
    return step_contact(material, pair_constants(material, a.radius, b.radius), motion, {{spring(p)}, {torque(p)}},
                        pass_step);
  }

  Material material;
  std::vector<Body<Real>> bodies;
  std::vector<std::uint32_t> first, second;
  std::vector<std::uint8_t> image;
  alignas(32) double shift[27][4] = {};
  std::vector<double> first_radius, second_radius;
  std::vector<Real> effective_radius, root_effective_mass, root_rolling_inertia, root_scale;
  std::array<std::vector<Real>, 6> history;
  std::vector<Load<Real>> loads;
  Real image_velocity = 0;
  std::vector<AcrossFaces> across;  ///< by block of grains
};

}  // namespace flowslide::native
