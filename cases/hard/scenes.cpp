// SPDX-License-Identifier: GPL-2.0-or-later
#include "scenes.hpp"

#include <algorithm>

namespace flowslide {
namespace {

std::vector<Scene> time_step_scenes() {
  return {{"time_step", "dt_L from 0.1 to 2 Rayleigh times",
           "tau up to 1 % strain at 0.1 t_R; 1 % accurate, 5 % stable", 30, time_step_scene},
          {"stiffness", "E from 0.1 to 70 GPa, dt_L following",
           "tau up to 0.6 % strain at 0.1 t_R of each E; 1 % accurate, 5 % stable", 10, stiffness_scene},
          {"dilation", "a dense sample stiffens at a fixed dt_L",
           "tau over 8 to 12 % strain at dt_L = 2e-6 s; 20 % accurate, 40 % stable (spread of one draw)", 15,
           dilation_scene}};
}

std::vector<Scene> coupling_scenes() {
  return {{"sliding_edge", "the slope on springs, dt_G from 0.01 to 10 times its edge",
           "the exact largest swing; 1 % accurate", 1, sliding_edge_scene},
          {"drainage_edge", "k from 0 to 1e-2 m/s, dt_G to 1e-2 s, Euler and exponential",
           "p_w falls as exp(-C M t); 1 % of p_w(0) accurate, 0 to p_w(0) stable", 1, drainage_edge_scene},
          {"drained_grains", "the same on grains at rest", "sigma stays sigma_0; 1 % accurate, 10 % stable", 30,
           drained_grains_scene},
          {"exchange", "dt_G from 1e-7 to 1e-1 s at I = 1e-2",
           "tau about its peak of the sample alone; 3 % accurate, 10 % stable", 15, exchange_scene},
          {"accumulation", "n_accum from 1 to 1000 at I = 1e-2",
           "tau about its peak of the sample alone; 3 % accurate, 10 % stable", 5, accumulation_scene},
          {"pulse", "pulses of A = 0, 1 Pa, 30 kPa; of 1 to 100 exchanges",
           "v = 0; of a run with half the steps (5 % accurate, 25 % stable); the impulse over the mass (5 %)", 10,
           pulse_scene},
          {"angle", "slopes of 0, 5, 15, 20 and 30 degrees", "a prepared slope stands: x = 0", 20, angle_scene}};
}

std::vector<Scene> liquefaction_scenes() {
  return {{"flow", "1000 % strain of a liquefied sample",
           "tau/sigma of steady flow, 0.4 +- 0.1 accurate, 0.2 to 0.7 stable", 15, flow_scene},
          {"resolidification", "v through zero, jam, dilation with p_w < 0",
           "tau, least p_w (5 % accurate, 20 % stable) and v (10, 50 %) of a run with half the steps", 40,
           resolidification_scene},
          {"no_stress", "sigma below 1 Pa", "stresses near 0, rates at the floor", 5, no_stress_scene}};
}

std::vector<Scene> grain_scenes() {
  return {{"fast_shear", "shear at 100 to 1000 /s",
           "stresses at dt_L = 2e-6 s, 15 % accurate, 40 % stable (spread of one draw); they grow with the square of "
           "the rate",
           20, fast_shear_scene},
          {"sizes", "size ratio 1:3, 100 and 27 grains", "tau up to 0.6 % strain at 0.1 t_R, 2 % accurate, 10 % stable",
           10, size_scene},
          {"material", "restitution 0.1 and 1, mu = 0, mu_r = 0",
           "tau up to 0.6 % strain at 0.1 t_R, 2 % accurate, 10 % stable", 20, material_scene},
          {"one_grain", "one grain in the cell", "straight lines, bounces by e, no stress: exact", 1, one_grain_scene},
          {"impact", "two grains in a line, 0.01 to 20 m/s", "they part with e = 0.8 of their speed; 0.02 accurate", 1,
           impact_scene},
          {"rattler", "a rattler hit at 0.1 to 500 m/s", "the energy never grows; 0.1 % accurate", 3, rattler_scene},
          {"pair_list", "pairs that open and close between list builds",
           "the same bits as with a new list at every step", 5, pair_list_scene},
          {"rest", "10 million steps at rest", "no drift of stress (0.1 %) nor of energy (0.1 %)", 40, rest_scene}};
}

constexpr double quick_grains = 6 * 6 * 7;  ///< number of grains for the predicted seconds above

}  // namespace

std::vector<Scene> scenes_of(const SceneSettings& settings) {
  std::vector<Scene> all;
  for (const auto& part : {time_step_scenes(), coupling_scenes(), liquefaction_scenes(), grain_scenes()})
    all.insert(all.end(), part.begin(), part.end());
  // Also scales the few scenes without a sample; they take only seconds.
  const auto& counts = settings.loose.packing.counts;
  const double grains = static_cast<double>(counts[0]) * counts[1] * counts[2];
  for (Scene& scene : all) scene.seconds *= std::max(1.0, grains / quick_grains);
  if (settings.large_lattice[0] > 0)
    all.push_back({"many_grains", "70 000 grains", "tau up to 0.6 % strain at 0.1 t_R, 2 % accurate, 10 % stable",
                   3600, many_grains_scene});
  return all;
}

}  // namespace flowslide
