// SPDX-License-Identifier: GPL-2.0-or-later
// Sliding and drainage below and above their limits of stability, on samples with an exact solution and on grains.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "sample/elastic_sample.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

constexpr const char* told_at_once = "passing = \"whole_increment\"\nrate = \"global\"\n";
constexpr double shear_modulus = 15e6, oedometric_modulus = 40e6;  // Pa, moduli of the elastic sample

ElasticSample elastic_sample(const SlopeProperties& slope, double normal_share) {
  ElasticProperties properties;
  properties.shear_modulus = shear_modulus;
  properties.oedometric_modulus = oedometric_modulus;
  properties.shear_stress = initial_shear_stress(slope);
  properties.normal_stress = normal_share * initial_normal_stress(slope);
  return ElasticSample(properties);
}

/// p_w after 0.1 s / p_w at the start, on the elastic sample. At the start p_w is 4 % of sigma_0.
double pressure_left(const SceneContext& context, double conductivity, double time_step, const std::string& scheme,
                     double bound) {
  SlopeProperties slope = context.settings().slope;
  slope.hydraulic_conductivity = conductivity;
  const SlideSettings settings = context.slide(
      fmt::format("{}time_step = \"{} s\"\nconsolidation = \"{}\"\nresidual = \"left_out\"\nshear_modulus = \"{} Pa\"\n"
                  "oedometric_modulus = \"{} Pa\"\n",
                  told_at_once, time_step, scheme, shear_modulus, bound),
      "", slope);
  ElasticSample sample = elastic_sample(slope, 0.96);
  Slide slide(settings, sample);
  const double first = slide.basal_pore_pressure();
  while (slide.state().time < 0.1 - 0.5 * time_step) slide.step();
  return slide.basal_pore_pressure() / first;
}

}  // namespace

SceneRecord sliding_edge_scene(const SceneContext& context) {
  constexpr double change = 100.0;  // Pa, applied at once: x oscillates up to twice the static displacement
  const SlopeProperties& slope = context.settings().slope;
  const double edge = sliding_time_step_limit(slope, shear_modulus);
  const double right = 2.0 * change * slope.liquefiable_thickness / shear_modulus;
  SceneRecord record;
  for (const double share : {0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 1.001, 1.01, 1.1, 2.0, 10.0}) {
    const auto swing = [&] {
      const SlideSettings settings = context.slide(
          fmt::format("{}time_step = \"{} s\"\nshear_modulus = \"{} Pa\"\n", told_at_once, share * edge, shear_modulus),
          fmt::format("history = \"constant\"\nchange = \"{} Pa\"\n", change), slope);
      ElasticSample sample = elastic_sample(slope, 1.0);
      Slide slide(settings, sample);
      double largest = 0.0;
      for (int step = 0; step < 20000; ++step) {
        slide.step();
        largest = std::max(largest, std::abs(slide.state().sliding.displacement));
      }
      return largest;
    };
    record.trials.push_back(attempt(fmt::format("dt_G = {} x 2/omega", share),
                                    {right, 0.01 * right, 0.5 * right, 1.01 * right, share > 1.0 ? "unstable" : ""},
                                    swing));
  }
  return record;
}

SceneRecord drainage_edge_scene(const SceneContext& context) {
  SceneRecord record;
  for (const double conductivity : {0.0, 1e-5, 1e-4, 1e-3, 1e-2})
    for (const double step : {1e-4, 1e-3, 1e-2})
      for (const char* scheme : {"euler", "exponential"}) {
        SlopeProperties slope = context.settings().slope;
        slope.hydraulic_conductivity = conductivity;
        const double right = std::exp(-consolidation_coefficient(slope) * oedometric_modulus * 0.1);
        const bool beyond = step > consolidation_time_step_limit(slope, oedometric_modulus);
        record.trials.push_back(
            attempt(fmt::format("k = {:.0e} m/s, dt_G = {:.0e} s, {}", conductivity, step, scheme),
                    {right, 0.01, 0.0, 1.0, beyond && std::string(scheme) == "euler" ? "unstable" : ""},
                    [&] { return pressure_left(context, conductivity, step, scheme, oedometric_modulus); }));
      }
  record.trials.push_back(attempt("k = 1e-02 m/s, dt_G = 1e-02 s, exponential with M = 100 MPa", {0.0, 0.01, 0.0, 1.0},
                                  [&] { return pressure_left(context, 1e-2, 1e-2, "exponential", 100e6); }));
  return record;
}

SceneRecord drained_grains_scene(const SceneContext& context) {
  // Without excess pore pressure the slope stands: sigma stays near sigma_0 and tau near tau_0 for every dt_G.
  const Assembly sample = context.prepared(context.settings().loose).assembly;
  SceneRecord record;
  for (const double conductivity : {0.0, 1e-4, 1e-3, 1e-2})
    for (const char* scheme : {"exponential", "euler"})
      for (const double step : {1e-4, 1e-3, 5e-3}) {
        SlopeProperties slope = context.settings().slope;
        slope.hydraulic_conductivity = conductivity;
        const double modulus = 100e6, normal = initial_normal_stress(slope);
        const bool beyond = step > consolidation_time_step_limit(slope, modulus);
        record.trials.push_back(attempt(
            fmt::format("grains, k = {:.0e} m/s, dt_G = {:.0e} s, {}", conductivity, step, scheme),
            {1.0, 0.01, 0.9, 1.1, beyond && std::string(scheme) == "euler" ? "unstable" : ""}, [&] {
              const SlideSettings settings =
                  context.slide(fmt::format("time_step = \"{} s\"\nconsolidation = \"{}\"\n", step, scheme), "", slope);
              return run_slide(context, sample, {.settings = settings, .stop = {.end_time = 0.1}}).stress.normal /
                     normal;
            }));
      }
  return record;
}

}  // namespace flowslide
