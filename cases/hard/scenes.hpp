// SPDX-License-Identifier: GPL-2.0-or-later
// The scenes. Each is one function that runs several settings and judges each of them.
#pragma once
#include <string>
#include <vector>

#include "trial.hpp"
#include "scene_context.hpp"

namespace flowslide {

struct Scene {
  std::string name;      ///< name of its point and its claim
  std::string title;     ///< what the scene does
  std::string right;     ///< the right value, and the tolerance with its origin
  double seconds = 1.0;  ///< predicted processor time on one core if the samples are in the cache, s
  SceneRecord (*run)(const SceneContext&);
};

// time_step_scenes.cpp
SceneRecord time_step_scene(const SceneContext& context);
SceneRecord stiffness_scene(const SceneContext& context);
SceneRecord dilation_scene(const SceneContext& context);
// slope_scenes.cpp
SceneRecord sliding_edge_scene(const SceneContext& context);
SceneRecord drainage_edge_scene(const SceneContext& context);
SceneRecord drained_grains_scene(const SceneContext& context);
// coupling_scenes.cpp
SceneRecord exchange_scene(const SceneContext& context);
SceneRecord accumulation_scene(const SceneContext& context);
// loading_scenes.cpp
SceneRecord pulse_scene(const SceneContext& context);
SceneRecord angle_scene(const SceneContext& context);
// liquefaction_scenes.cpp
SceneRecord flow_scene(const SceneContext& context);
SceneRecord resolidification_scene(const SceneContext& context);
SceneRecord no_stress_scene(const SceneContext& context);
// material_scenes.cpp
SceneRecord fast_shear_scene(const SceneContext& context);
SceneRecord size_scene(const SceneContext& context);
SceneRecord material_scene(const SceneContext& context);
SceneRecord many_grains_scene(const SceneContext& context);
// grain_scenes.cpp
SceneRecord one_grain_scene(const SceneContext& context);
SceneRecord impact_scene(const SceneContext& context);
SceneRecord rattler_scene(const SceneContext& context);
SceneRecord pair_list_scene(const SceneContext& context);
// rest_scenes.cpp
SceneRecord rest_scene(const SceneContext& context);

/// All scenes, in the order of the table.
std::vector<Scene> scenes_of(const SceneSettings& settings);

}  // namespace flowslide
