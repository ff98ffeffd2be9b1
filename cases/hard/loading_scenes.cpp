// SPDX-License-Identifier: GPL-2.0-or-later
// Pulses that are very small, very large or very short, and slopes from level to steep.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "experiments.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

std::string pulse(double amplitude, double duration) {
  return fmt::format("history = \"pulse\"\namplitude = \"{} Pa\"\nduration = \"{} s\"\n", amplitude, duration);
}

/// Sliding velocity at the end of a pulse, m/s. `amplitude`: Pa; `duration`: s.
double velocity_after(const SceneContext& context, const Assembly& sample, const std::string& coupling,
                      double amplitude, double duration) {
  const SlideSettings settings = context.slide(coupling, pulse(amplitude, duration), context.settings().slope);
  return run_slide(context, sample, {.settings = settings, .stop = {.end_time = duration}}).velocity;
}

}  // namespace

SceneRecord pulse_scene(const SceneContext& context) {
  const Assembly sample = context.prepared(context.settings().loose).assembly;
  const double mass = mass_per_area(context.settings().slope);
  const auto impulse = [&](double amplitude, double duration) {  // v after the pulse without resistance
    return 2.0 / std::numbers::pi * amplitude * duration / mass;
  };
  SceneRecord record;
  record.trials.push_back(attempt("A = 0, T = 0.2 s", {0.0, 1e-6, -1e-5, 1e-5},
                                  [&] { return velocity_after(context, sample, "", 0.0, 0.2); }));
  record.trials.push_back(attempt("A = 1 Pa, T = 0.2 s", {0.0, 1e-5, -impulse(1, 0.2), impulse(1, 0.2)},
                                  [&] { return velocity_after(context, sample, "", 1.0, 0.2); }));
  const double huge =
      velocity_after(context, sample, "time_step = \"5e-5 s\"\nlocal_time_step = \"2e-6 s\"\n", 30e3, 0.05);
  record.trials.push_back(attempt("A = 30 kPa, T = 0.05 s", relative(huge, 0.05, 0.25), [&] {
    return velocity_after(context, sample, "local_time_step = \"4e-6 s\"\n", 30e3, 0.05);
  }));
  for (const int exchanges : {1, 2, 5, 10, 100}) {
    // Expected is the impulse of the pulse. The strength of the sample takes a small part of it.
    const double duration = exchanges * 1e-4, amplitude = 3e5, free = impulse(amplitude, duration);
    record.trials.push_back(attempt(fmt::format("A = 300 kPa, T = {} exchanges", exchanges),
                                    relative(free, 0.05, 0.2, exchanges < 10 ? "pulse" : ""),
                                    [&] { return velocity_after(context, sample, "", amplitude, duration); }));
  }
  return record;
}

SceneRecord angle_scene(const SceneContext& context) {
  SceneRecord record;
  for (const double degrees : {0.0, 5.0, 15.0, 20.0, 30.0}) {
    const auto displacement = [&] {
      SlopeProperties slope = context.settings().slope;
      slope.angle = degrees * std::numbers::pi / 180.0;
      SampleRecipe recipe = context.settings().dense;
      recipe.normal_stress = initial_normal_stress(slope);
      recipe.shear_stress = initial_shear_stress(slope);
      const Assembly sample = context.prepared(recipe).assembly;
      const SlideSettings settings = context.slide("", "", slope);
      return run_slide(context, sample, {.settings = settings, .stop = {.end_time = 0.2}}).sliding.displacement;
    };
    // A slope in balance stands. The stress residual of the servo may move it by about 1e-6 of the thickness of the
    // layer.
    record.trials.push_back(attempt(fmt::format("{} degrees", degrees),
                                    {0.0, 2e-7, -2e-5, 2e-5, degrees > 16.0 ? "sample" : ""}, displacement));
  }
  return record;
}

}  // namespace flowslide
