// SPDX-License-Identifier: GPL-2.0-or-later
// The three scenes that every choice is tried on, and the numbers by which a run of one is compared: windows and first
// passages, never a point of a curve beyond the peak.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "program/slide_case.hpp"

namespace flowslide {

enum class Scene { element, trigger, pulse };
inline constexpr std::array all_scenes{Scene::element, Scene::trigger, Scene::pulse};

/// "element", "trigger", "pulse".
std::string name_of(Scene scene);
/// An element test, a slide after a pulse, or a slide under any other loading: a trigger.
Scene scene_of(const SlidePoint& point);

/// The metrics whose errors count in a scene (see scene_metrics).
std::vector<std::string> quantities_of(Scene scene);

/// The numbers of one run. Those that the record does not have are not numbers.
///   element  peak_shear_stress       Pa, largest tau up to 2 % strain, by a parabola through three rows
///            strain_at_peak          1, the strain there
///            strain_at_liquefaction  1, where sigma first falls below a tenth of what it was
///   trigger  instability_time        s, when tau is largest up to 2 % strain: from then on tau falls while tau_d grows
///            velocity_at_half        m/s, mean of v over 49.5 to 50.5 % strain
///   pulse    largest_velocity        m/s, largest mean of v over 0.1 s
///            runout                  m, sliding distance at the end
/// and of all with grains: grains, steps, grain_steps (1), processor_seconds (s, of the sample's strain() alone: no
/// preparation, no records), steps_per_second (1/s). duration (s) is the end of the record, for a slide on the clock of
/// the slope.
std::vector<Metric> scene_metrics(const SlideOutcome& outcome);

}  // namespace flowslide
