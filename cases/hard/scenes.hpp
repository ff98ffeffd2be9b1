// SPDX-License-Identifier: GPL-2.0-or-later
// The scenes of the suite. Each is one function that runs several settings and judges each of them.
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
  SceneRecord (*run)(const Workshop&);
};

// time_step_scenes.cpp
SceneRecord time_step_scene(const Workshop& workshop);
SceneRecord stiffness_scene(const Workshop& workshop);
SceneRecord dilation_scene(const Workshop& workshop);
// slope_scenes.cpp
SceneRecord sliding_edge_scene(const Workshop& workshop);
SceneRecord drainage_edge_scene(const Workshop& workshop);
SceneRecord drained_grains_scene(const Workshop& workshop);
// coupling_scenes.cpp
SceneRecord exchange_scene(const Workshop& workshop);
SceneRecord accumulation_scene(const Workshop& workshop);
// loading_scenes.cpp
SceneRecord pulse_scene(const Workshop& workshop);
SceneRecord angle_scene(const Workshop& workshop);
// liquefaction_scenes.cpp
SceneRecord flow_scene(const Workshop& workshop);
SceneRecord resolidification_scene(const Workshop& workshop);
SceneRecord no_stress_scene(const Workshop& workshop);
// material_scenes.cpp
SceneRecord fast_shear_scene(const Workshop& workshop);
SceneRecord size_scene(const Workshop& workshop);
SceneRecord material_scene(const Workshop& workshop);
SceneRecord many_grains_scene(const Workshop& workshop);
// grain_scenes.cpp
SceneRecord one_grain_scene(const Workshop& workshop);
SceneRecord impact_scene(const Workshop& workshop);
SceneRecord rattler_scene(const Workshop& workshop);
SceneRecord pair_list_scene(const Workshop& workshop);
// rest_scenes.cpp
SceneRecord rest_scene(const Workshop& workshop);

/// All scenes of a suite, in the order of the table.
std::vector<Scene> scenes_of(const Suite& suite);

}  // namespace flowslide
