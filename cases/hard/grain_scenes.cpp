// SPDX-License-Identifier: GPL-2.0-or-later
// Scenes with few grains, and with single grains that move fast.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "dem/native/native_engine.hpp"
#include "experiments.hpp"
#include "grains/contact_search.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

/// Grains of 6 mm at rest in a cell of 40 mm, periodic in x and y.
Assembly cell_with(const std::vector<Vector3>& positions) {
  Assembly grains;
  grains.cell.upper.setConstant(0.04);
  grains.cell.periodic = {true, true, false};
  grains.resize(positions.size());
  grains.radius.assign(positions.size(), 3e-3);
  grains.position = positions;
  return grains;
}

/// Coefficient of restitution: speed of separation / speed of approach in a central impact of two grains.
double restitution_of(const SceneContext& context, const Material& material, double speed, double time_step) {
  Assembly pair = cell_with({{0.0, 0.02, 0.02}, {0.0062, 0.02, 0.02}});
  pair.position[0].x() = 0.0391;  // the grains collide across the periodic face
  pair.position[1].x() = 0.0054;
  pair.velocity[0].x() = 0.5 * speed;
  pair.velocity[1].x() = -0.5 * speed;
  const auto engine = context.engine();
  engine->load(pair, {material, time_step, 0.0});
  engine->run(std::llround((0.5e-3 / speed + 20.0 * std::max(1e-5, 3e-5 * std::pow(speed, -0.2))) / time_step));
  const Assembly after = engine->save();
  return (after.velocity[1].x() - after.velocity[0].x()) / speed;
}

/// The mobile grain with the fewest contacts.
std::size_t rattler_of(const Assembly& sample) {
  std::vector<int> contacts(sample.size(), 0);
  for (const TouchingPair& pair : touching_pairs(sample)) {
    ++contacts[pair.first];
    ++contacts[pair.second];
  }
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (sample.role[i] != Role::mobile) contacts[i] = 1000;
  return static_cast<std::size_t>(std::min_element(contacts.begin(), contacts.end()) - contacts.begin());
}

/// The sample with random velocities of its mobile grains, up to `speed` (m/s) along each axis.
Assembly kicked(Assembly sample, double speed) {
  std::mt19937_64 random(1);
  for (std::size_t i = 0; i < sample.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (sample.role[i] == Role::mobile)
        sample.velocity[i][axis] = speed * (static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0);
  return sample;
}

double farthest(const Assembly& a, const Assembly& b) {
  double distance = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    distance = std::max(distance, a.cell.nearest_image(a.position[i] - b.position[i]).norm());
  return distance;
}

}  // namespace

SceneRecord one_grain_scene(const SceneContext& context) {
  const EngineSettings settings{context.settings().material, 1e-5, 0.0};
  SceneRecord record;
  record.trials.push_back(attempt("alone, across periodic faces: error of its place, m", {0.0, 1e-12, 0.0, 1e-9}, [&] {
    Assembly one = cell_with({{0.01, 0.02, 0.02}});
    one.velocity[0] = {1.234, -0.567, 0.0};
    const auto engine = context.engine();
    engine->load(one, settings);
    engine->run(100000);
    const Vector3 exact = one.position[0] + one.velocity[0];  // after one second
    return one.cell.nearest_image(engine->save().position[0] - exact).norm();
  }));
  record.trials.push_back(
      attempt("between the planes: speed after 5 bounces, m/s", {std::pow(0.8, 5), 0.01, 0.2, 1.0}, [&] {
        Assembly one = cell_with({{0.01, 0.02, 0.02}});
        one.velocity[0].z() = 1.0;
        const auto engine = context.engine();
        engine->load(one, {settings.material, 1e-6, 0.0});
        int bounces = 0;
        for (double before = 1.0; bounces < 5;) {
          engine->run(100);
          const double now = engine->save().velocity[0].z();
          if (before * now < 0.0) ++bounces;
          before = now;
        }
        engine->run(1000);  // the grain leaves the plane
        return std::abs(engine->save().velocity[0].z());
      }));
  record.trials.push_back(attempt("stress of a cell without contacts, Pa", {0.0, 0.0, 0.0, 0.0}, [&] {
    const auto engine = context.engine();
    engine->load(cell_with({{0.01, 0.02, 0.02}}), settings);
    engine->run(10);
    return engine->cell_stress().mean();
  }));
  record.trials.push_back(attempt("as a sample", {0.0, 0.0, 0.0, 0.0, "glued layer"}, [&] {
    const auto engine = context.engine();
    return DemSample(*engine, cell_with({{0.01, 0.02, 0.02}}), settings).mean_stress();
  }));
  return record;
}

SceneRecord impact_scene(const SceneContext& context) {
  SceneRecord record;
  Material material = context.settings().material;
  for (const std::string& law : contact_law_names()) {
    material.contact_law = contact_law_of(law);
    for (const double speed : {0.01, 0.1, 1.0, 5.0, 20.0})
      for (const double step : {1e-7, 1e-6, 1e-5})
        record.trials.push_back(attempt(fmt::format("{}, {} m/s, dt_L = {:.0e} s", law, speed, step),
                                        {material.restitution, 0.02, 0.0, 1.0},
                                        [&] { return restitution_of(context, material, speed, step); }));
  }
  return record;
}

SceneRecord rattler_scene(const SceneContext& context) {
  const PreparedSample prepared = context.prepared(context.settings().loose);
  const Material& material = context.settings().material;
  SceneRecord record;
  for (const double speed : {0.1, 1.0, 10.0, 50.0, 500.0}) {
    record.trials.push_back(attempt(fmt::format("{} m/s: largest energy over that at the start", speed),
                                    {1.0, 1e-3, 0.0, 1.01, speed > 5.0 ? "time step" : ""}, [&] {
                                      Assembly sample = prepared.assembly;
                                      sample.velocity[rattler_of(sample)] = speed * Vector3(1.0, 1.0, 1.0).normalized();
                                      const auto engine = context.engine();
                                      DemSample hit(*engine, sample, {material, 1e-5, 0.0});
                                      const double first = energy_of(sample, material);
                                      double largest = first;
                                      for (int reading = 0; reading < 200; ++reading) {
                                        hit.strain({{0.0, 0.0}, 10, 1e-5});
                                        largest = std::max(largest, energy_of(hit.assembly(), material));
                                      }
                                      return largest / first;
                                    }));
  }
  return record;
}

SceneRecord pair_list_scene(const SceneContext& context) {
  const Assembly sample = context.prepared(context.settings().loose).assembly;
  const EngineSettings settings{context.settings().material, 1e-6, 0.0};
  SceneRecord record;
  for (const double speed : {0.1, 1.0, 10.0}) {
    const Assembly start = kicked(sample, speed);
    const auto after = [&](double allowance) {
      DoubleEngine engine({.first_allowance = allowance});
      engine.load(start, settings);
      engine.run(2000);
      return engine.save();
    };
    const Assembly right = after(0.0);  // the pair list is built as often as possible
    for (const double allowance : {1e-3, 1e-2, 1e-1})
      record.trials.push_back(
          attempt(fmt::format("{} m/s, a list good for {} diameters: distance after 2000 steps, m", speed, allowance),
                  {0.0, 0.0, 0.0, 0.0}, [&] { return farthest(right, after(allowance)); }));
  }
  return record;
}

}  // namespace flowslide
