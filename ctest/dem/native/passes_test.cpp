// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/contact_pass.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "dem/native/cell_grid.hpp"
#include "grains/contact_law.hpp"
#include "support/clustered_cloud.hpp"

namespace flowslide::native {
namespace {

constexpr double step = 1e-6;

Material material_of(LawVariant variant) {
  Material m;
  if (variant != LawVariant::sliding_and_rolling) m.rolling_friction = 0.0;
  if (variant == LawVariant::frictionless) m.sliding_friction = 0.0;
  return m;
}

LawConstants constants_of(const Material& m) {
  const PairConstants pair = pair_constants(m, 1.0, 1.0);
  const double dashpot = -2.0 * std::sqrt(5.0 / 6.0) * pair.damping;
  return {4.0 / 3.0 * pair.effective_modulus,
          dashpot * std::sqrt(2.0 * pair.effective_modulus),
          8.0 * pair.effective_shear_modulus,
          dashpot * std::sqrt(8.0 * pair.effective_shear_modulus),
          m.sliding_friction,
          m.rolling_friction,
          m.rolling_stiffness * m.rolling_friction * m.rolling_friction,
          2.0 * m.rolling_viscous_damping,
          step};
}

/// Random pairs, each of two grains of its own unless told otherwise, some open, some through a periodic image, with
/// random histories, sticking and sliding.
struct RandomPairs {
  explicit RandomPairs(std::uint64_t seed, std::size_t count = 4 * tile_size) : bodies(2 * count) {
    Dice dice(seed);
    const Material m;
    for (int axis = 0; axis < 3; ++axis)
      for (int k = 0; k < 27; ++k) shift[k][axis] = 0.0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) Vector3::Map(shift[image_of(x, y, z)]) = Vector3(0.1 * x, 0.2 * y, 0.3 * z);
    for (std::size_t p = 0; p < count; ++p) {
      const auto i = static_cast<std::uint32_t>(2 * p), j = i + 1;
      first.push_back(i);
      second.push_back(j);
      image.push_back(p % 3 == 0 ? static_cast<std::uint8_t>(dice.below(27)) : image_of(0, 0, 0));
      for (const std::uint32_t k : {i, j}) {
        Body& body = bodies[k];
        body.radius = dice.between(1e-3, 3e-3);
        body.mass = sphere_mass(body.radius, m);
        body.inertia = sphere_inertia(body.radius, m);
        Vector3::Map(body.velocity) = dice.vector(dice.below(2) == 0 ? 1e-2 : 1.0);
        Vector3::Map(body.spin) = dice.vector(10.0);
        Vector3::Map(body.position) = dice.vector(0.1);
      }
      const double reach = bodies[i].radius + bodies[j].radius;
      const Vector3 apart = dice.vector(1.0).normalized() * reach * (1.0 - dice.between(-0.01, 0.02));
      Vector3::Map(bodies[j].position) = Vector3::Map(bodies[i].position) - apart - Vector3::Map(shift[image[p]]);
      const PairConstants c = pair_constants(m, bodies[i].radius, bodies[j].radius);
      first_radius.push_back(bodies[i].radius);
      second_radius.push_back(bodies[j].radius);
      effective_radius.push_back(c.effective_radius);
      root_effective_mass.push_back(std::sqrt(c.effective_mass));
      root_rolling_inertia.push_back(std::sqrt(c.rolling_inertia));
      const Vector3 s = dice.vector(dice.below(2) == 0 ? 1e-8 : 1e-5),
                    t = dice.vector(dice.below(2) == 0 ? 1e-7 : 1e-3);
      for (int axis = 0; axis < 3; ++axis) {
        history[axis].push_back(s[axis]);
        history[axis + 3].push_back(t[axis]);
      }
    }
  }

  PairView view() {
    PairView v{};
    v.count = first.size();
    v.first = first.data();
    v.second = second.data();
    v.image = image.data();
    v.image_shift = shift;
    v.first_radius = first_radius.data();
    v.second_radius = second_radius.data();
    v.effective_radius = effective_radius.data();
    v.root_effective_mass = root_effective_mass.data();
    v.root_rolling_inertia = root_rolling_inertia.data();
    for (int axis = 0; axis < 3; ++axis) {
      v.spring[axis] = history[axis].data();
      v.rolling_torque[axis] = history[axis + 3].data();
    }
    return v;
  }
  /// Separation and overlap as the pass computes them, to the bit.
  Vector3 separation(std::size_t p) const {
    return Vector3::Map(bodies[first[p]].position) -
           (Vector3::Map(bodies[second[p]].position) + Vector3::Map(shift[image[p]]));
  }
  double overlap(std::size_t p) const {
    const Vector3 d = separation(p);
    return first_radius[p] + second_radius[p] - std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
  }
  Vector3 spring(std::size_t p) const { return {history[0][p], history[1][p], history[2][p]}; }
  Vector3 torque(std::size_t p) const { return {history[3][p], history[4][p], history[5][p]}; }

  std::vector<Body> bodies;
  std::vector<std::uint32_t> first, second;
  std::vector<std::uint8_t> image;
  alignas(32) double shift[27][4] = {};
  std::vector<double> first_radius, second_radius, effective_radius, root_effective_mass, root_rolling_inertia;
  std::array<std::vector<double>, 6> history;
};

constexpr LawVariant variants[] = {LawVariant::frictionless, LawVariant::sliding, LawVariant::sliding_and_rolling};

TEST(ContactPass, EveryLawIsThatOfTheGrains) {
  std::size_t open = 0, sliding = 0, rolling = 0, sticking = 0;
  for (const LawVariant variant : variants) {
    const Material m = material_of(variant);
    RandomPairs pairs(3);
    const RandomPairs before = pairs;
    std::vector<Load> loads(pairs.bodies.size(), Load{});
    contact_pass()(variant, constants_of(m), pairs.view(), pairs.bodies.data(), loads.data(), nullptr);
    for (std::size_t p = 0; p < pairs.first.size(); ++p) {
      const Body &a = pairs.bodies[2 * p], &b = pairs.bodies[2 * p + 1];
      if (pairs.overlap(p) <= 0.0) continue;
      const PairConstants c = pair_constants(m, a.radius, b.radius);
      const Vector3 normal = pairs.separation(p) / (a.radius + b.radius - pairs.overlap(p));
      const ContactKinematics motion{normal, pairs.overlap(p), Vector3::Map(a.velocity) - Vector3::Map(b.velocity),
                                     Vector3::Map(a.spin), Vector3::Map(b.spin)};
      const ContactForce law = evaluate_contact(m, c, motion, before.spring(p), before.torque(p), step, true);
      // Some ten rounded operations; the scale is that of the terms, as spring and dashpot may cancel.
      const double force = normal_force(c, motion.overlap, 0.0) + law.on_first.norm();
      EXPECT_LT((Vector3::Map(loads[2 * p].force) - law.on_first).norm(), 1e-13 * force);
      EXPECT_EQ(Vector3::Map(loads[2 * p].force), -Vector3::Map(loads[2 * p + 1].force));
      const double torque = force * a.radius + law.rolling_torque.norm();
      EXPECT_LT((Vector3::Map(loads[2 * p].torque) - law.torque_on_first).norm(), 1e-13 * torque);
      EXPECT_LT((Vector3::Map(loads[2 * p + 1].torque) - law.torque_on_second).norm(), 1e-13 * torque);
      if (variant != LawVariant::frictionless) {
        EXPECT_LT((pairs.spring(p) - law.tangential_spring).norm(), 1e-13 * before.spring(p).norm() + 1e-19);
        ++(law.sliding ? sliding : sticking);
      }
      if (variant != LawVariant::sliding_and_rolling) continue;
      EXPECT_LT((pairs.torque(p) - law.rolling_torque).norm(), 1e-13 * before.torque(p).norm() + 1e-19);
      rolling += law.rolling;
    }
  }
  for (std::size_t p = 0; p < RandomPairs(3).first.size(); ++p) open += RandomPairs(3).overlap(p) <= 0.0;
  EXPECT_GT(open, 20u);  // the example has all cases in it
  EXPECT_GT(sliding, 20u);
  EXPECT_GT(sticking, 20u);
  EXPECT_GT(rolling, 20u);
}

TEST(ContactPass, OpenPairsAddExactZerosAndForgetTheirHistories) {
  for (const LawVariant variant : variants) {
    RandomPairs pairs(4);
    std::vector<Load> loads(pairs.bodies.size(), Load{{1, 2, 3}, 0, {4, 5, 6}, 0});
    contact_pass()(variant, constants_of(material_of(variant)), pairs.view(), pairs.bodies.data(), loads.data(),
                   nullptr);
    std::size_t open = 0;
    for (std::size_t p = 0; p < pairs.first.size(); ++p) {
      if (pairs.overlap(p) > 0.0) continue;
      ++open;
      for (const std::size_t i : {2 * p, 2 * p + 1}) {
        EXPECT_EQ(Vector3::Map(loads[i].force), Vector3(1, 2, 3));
        EXPECT_EQ(Vector3::Map(loads[i].torque), Vector3(4, 5, 6));
      }
      if (variant == LawVariant::frictionless) continue;
      EXPECT_EQ(pairs.spring(p), Vector3(0, 0, 0));
      if (variant == LawVariant::sliding) continue;
      EXPECT_EQ(pairs.torque(p), Vector3(0, 0, 0));
    }
    EXPECT_GT(open, 20u);
  }
}

TEST(ContactPass, EveryInstructionSetGivesTheSameBits) {
  int sets = 0;
  for (const LawVariant variant : variants)
    for (const bool shared : {false, true}) {
      std::vector<Load> expected;
      std::array<std::vector<double>, 6> history;
      double expected_virial[2] = {0.0, 0.0};
      for (const char* set : {"baseline", "avx2", "avx512"}) {
        const ContactPass pass = contact_pass(set);
        if (!pass) continue;
        ++sets;
        RandomPairs pairs(5);
        if (shared)  // neighbours in the list share their first grain, as in a real one
          for (std::size_t p = 0; p < pairs.first.size(); p += 2) {
            pairs.first[p + 1] = pairs.first[p];
            pairs.first_radius[p + 1] = pairs.first_radius[p];
          }
        std::vector<Load> loads(pairs.bodies.size(), Load{});
        double virial[2] = {0.0, 0.0};
        pass(variant, constants_of(material_of(variant)), pairs.view(), pairs.bodies.data(), loads.data(), virial);
        if (expected.empty()) {
          expected = loads;
          history = pairs.history;
          std::memcpy(expected_virial, virial, sizeof virial);
        }
        EXPECT_EQ(std::memcmp(loads.data(), expected.data(), loads.size() * sizeof(Load)), 0) << set;
        EXPECT_EQ(pairs.history, history) << set;
        EXPECT_EQ(std::memcmp(virial, expected_virial, sizeof virial), 0) << set;
      }
    }
  EXPECT_GE(sets, 6) << "not even the baseline is there";
  RecordProperty("instruction_sets", sets / 6);
}

TEST(ContactPass, VirialIsTheSumOverPairs) {
  RandomPairs pairs(6);
  std::vector<Load> loads(pairs.bodies.size(), Load{});
  double virial[2] = {0.0, 0.0};
  contact_pass()(LawVariant::sliding_and_rolling, constants_of(Material{}), pairs.view(), pairs.bodies.data(),
                 loads.data(), virial);
  for (int axis = 0; axis < 2; ++axis) {
    double sum = 0.0, size = 0.0;
    for (std::size_t p = 0; p < pairs.first.size(); ++p) {
      const double part = pairs.separation(p)[axis] * loads[2 * p].force[axis];
      sum += part;
      size += std::abs(part);
    }
    EXPECT_NEAR(virial[axis], sum, 1e-14 * size);  // 256 rounded terms
    EXPECT_GT(size, 0.0);
  }
}

/// Bodies with loads on them, one in three glued.
struct MovingBodies {
  explicit MovingBodies(std::size_t count = 41) : bodies(RandomPairs(7).bodies), loads(count, Load{}) {
    Dice dice(8);
    bodies.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      Vector3::Map(loads[i].force) = dice.vector(1.0);
      Vector3::Map(loads[i].torque) = dice.vector(1e-3);
      kick.push_back(i % 3 == 0 ? 0.0 : 0.5 * step / bodies[i].mass);
      twist.push_back(i % 3 == 0 ? 0.0 : 0.5 * step / bodies[i].inertia);
    }
  }
  double move(MotionPass pass, MotionPart part) {
    return pass(part, bodies.size(), step, kick.data(), twist.data(), flow, bodies.data(), loads.data());
  }
  std::vector<Body> bodies;
  std::vector<Load> loads;
  std::vector<double> kick, twist;
  MeanFlow flow{{0.1, 0.2, 0.3, 0.0}, {3.0, 2.0, 1.0, 0.0}, 0.01};
};

TEST(MotionPass, IsVelocityVerletAndEveryInstructionSetGivesItsBits) {
  for (const MotionPart part : {MotionPart::end, MotionPart::begin, MotionPart::end_and_begin})
    for (const char* set : {"baseline", "avx2", "avx512"}) {
      const MotionPass pass = motion_pass(set);
      if (!pass) continue;
      MovingBodies moving;
      const MovingBodies before;
      const double returned = moving.move(pass, part);
      double fastest = 0.0;
      for (std::size_t i = 0; i < before.bodies.size(); ++i) {
        const Body& body = before.bodies[i];
        const int kicks = part == MotionPart::end_and_begin ? 2 : 1;
        Vector3 velocity = Vector3::Map(body.velocity), spin = Vector3::Map(body.spin);
        for (int k = 0; k < kicks; ++k) {
          velocity += before.kick[i] * Vector3::Map(before.loads[i].force);
          spin += before.twist[i] * Vector3::Map(before.loads[i].torque);
        }
        Vector3 position = Vector3::Map(body.position);
        const Vector3 flow =
            Vector3::Map(moving.flow.base) + (position.z() - moving.flow.origin) * Vector3::Map(moving.flow.slope);
        if (part != MotionPart::end) position += step * velocity;
        fastest = std::max(fastest, (velocity - flow).squaredNorm());
        EXPECT_EQ(Vector3::Map(moving.bodies[i].velocity), velocity) << set;
        EXPECT_EQ(Vector3::Map(moving.bodies[i].spin), spin) << set;
        EXPECT_EQ(Vector3::Map(moving.bodies[i].position), position) << set;
        EXPECT_EQ(moving.bodies[i].radius, body.radius);
        EXPECT_EQ(moving.bodies[i].mass, body.mass);
        EXPECT_EQ(moving.bodies[i].inertia, body.inertia);
        // A beginning leaves no load behind, an end leaves all of it.
        const double left = part == MotionPart::end ? 1.0 : 0.0;
        EXPECT_EQ(Vector3::Map(moving.loads[i].force), left * Vector3::Map(before.loads[i].force));
        EXPECT_EQ(Vector3::Map(moving.loads[i].torque), left * Vector3::Map(before.loads[i].torque));
      }
      // A few rounded sums.
      EXPECT_NEAR(returned, part == MotionPart::end ? 0.0 : fastest, 2e-15 * fastest) << set;
    }
}

TEST(ContactPass, KnowsNoOtherInstructionSet) {
  EXPECT_EQ(contact_pass("sse"), nullptr);
  EXPECT_NE(contact_pass("baseline"), nullptr);
  EXPECT_NE(contact_pass(), nullptr);
}

}  // namespace
}  // namespace flowslide::native
