// SPDX-License-Identifier: GPL-2.0-or-later
// A sample that has lost its strength for a long time, or regains it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "scenes.hpp"

namespace flowslide {

SceneRecord flow_scene(const SceneContext& context) {
  constexpr double strain = 10.0, settled = 2.0;
  const Material& material = context.settings().material;
  const Assembly sample = expanded(context, 0.03);
  SceneRecord record;
  for (const double rate : {5.0, 20.0}) {
    // tau/sigma of steady flow of spheres with mu = 0.5 is 0.3 to 0.6, from quasi-static to collisional flow.
    record.trials.push_back(
        attempt(fmt::format("tau/sigma at {} /s over 200 to 1000 %", rate), {0.4, 0.1, 0.2, 0.7}, [&] {
          const auto readings = shear(context, sample, {material, 4e-6}, {rate, strain, 2000});
          return mean_shear(readings, settled) / mean_normal(readings, settled);
        }));
  }
  return record;
}

SceneRecord resolidification_scene(const SceneContext& context) {
  // A dense sample under a pulse slides, dilates (p_w < 0) and jams; v changes its sign.
  const Assembly sample = context.prepared(context.settings().dense).assembly;
  const SlopeProperties& slope = context.settings().slope;
  struct Course {
    double stress = 0.0;           // mean tau after the pulse, Pa
    double lowest_pressure = 0.0;  // lowest p_w, Pa
    double lowest_velocity = 0.0;  // m/s
  };
  const auto follow = [&](const std::string& coupling) {
    const SlideSettings settings =
        context.slide("rate = \"at_least_quasi_static\"\ninertial_number = 1e-4\n" + coupling,
                      "history = \"pulse\"\namplitude = \"15 kPa\"\nduration = \"0.2 s\"\n", slope);
    Course course;
    double time = 0.0;
    const auto add = [&](const Slide& slide) {
      course.lowest_pressure = std::min(course.lowest_pressure, slide.basal_pore_pressure());
      course.lowest_velocity = std::min(course.lowest_velocity, slide.state().velocity);
      if (slide.state().time < 0.25) return;
      course.stress += slide.state().stress.shear * settings.time_step;
      time += settings.time_step;
    };
    run_slide(context, sample, {.settings = settings, .stop = {.end_time = 0.4}, .observe = add});
    course.stress /= time;
    return course;
  };
  const Course right = follow("time_step = \"5e-5 s\"\nlocal_time_step = \"3e-6 s\"\n");
  SceneRecord record;
  for (const char* passing : {"carry_remainder", "variable_time_step"}) {
    Course course;
    record.trials.push_back(
        attempt(fmt::format("tau after the pulse, {}, Pa", passing), relative(right.stress, 0.05, 0.2), [&] {
          course = follow(fmt::format("passing = \"{}\"\nlocal_time_step = \"6e-6 s\"\n", passing));
          return course.stress;
        }));
    record.trials.push_back(attempt(fmt::format("least p_w, {}, Pa", passing),
                                    relative(right.lowest_pressure, 0.05, 0.2),
                                    [&] { return course.lowest_pressure; }));
    record.trials.push_back(attempt(fmt::format("least v, {}, m/s", passing), relative(right.lowest_velocity, 0.1, 0.5),
                                    [&] { return course.lowest_velocity; }));
  }
  return record;
}

SceneRecord no_stress_scene(const SceneContext& context) {
  // The sample is expanded until sigma is nearly 0, then sheared. The stresses vanish; no rule may divide by them.
  const Material& material = context.settings().material;
  const Assembly sample = context.prepared(context.settings().loose).assembly;
  const auto engine = context.engine();
  DemSample expanded(*engine, sample, {material, 1e-5, 0.0});
  SceneRecord record;
  double stress = 0.0;
  record.trials.push_back(attempt("sigma after expansion by 3 %, Pa", {0.0, 1.0, -10.0, 10.0}, [&] {
    expanded.strain({{0.0, -0.1}, 30000, 1e-5});
    expanded.strain({{0.0, 0.0}, 20000, 1e-5});
    return stress = expanded.stress().normal;
  }));
  const GrainScale grains{sample.mean_diameter(), material.density};
  for (const double pressure : {stress, 1e-3, 1e-12, 0.0, -1.0})
    record.trials.push_back(
        attempt(fmt::format("rate of RI at sigma = {:.1e} Pa", pressure), {0.5, 1e-2, 0.5, 1.0}, [&] {
          return rate_asked(ConstantInertialNumber{1e-4, 0.5, grains}, 0.1, pressure, 1.0);
        }));
  record.trials.push_back(
      attempt("mean stress of the bulk, Pa", {0.0, 1.0, 0.0, 50.0}, [&] { return expanded.mean_stress(); }));
  record.trials.push_back(attempt("sigma sheared on by 20 %, Pa", {0.0, 1.0, -20.0, 200.0}, [&] {
    return expanded.strain({{1.0, 0.0}, 20000, 1e-5}).normal;
  }));
  return record;
}

}  // namespace flowslide
