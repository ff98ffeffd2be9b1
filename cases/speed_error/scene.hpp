// SPDX-License-Identifier: GPL-2.0-or-later
// The three scenes in which each choice is tested, and the metrics by which their runs are compared. The metrics are
// means over windows, peaks and first passages; single points of a curve beyond the peak are too noisy.
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
/// The scene of a point: `element` for an element test, `pulse` for a slide with a pulse, `trigger` for any other
/// slide.
Scene scene_of(const SlidePoint& point);

/// The metrics whose errors count in a scene (see scene_metrics).
std::vector<std::string> quantities_of(Scene scene);

/// The metrics of one run; NaN for a metric that the record does not have.
///   element  peak_shear_stress       Pa, largest tau up to 2 % strain, by a parabola through three rows
///            strain_at_peak          1, strain at this peak
///            strain_at_liquefaction  1, strain where sigma first falls to 0.1 of its initial value
///   trigger  instability_time        s, time of the largest tau up to 2 % strain; after it tau falls while tau_d grows
///            velocity_at_half        m/s, mean of v from 49.5 to 50.5 % strain
///   pulse    largest_velocity        m/s, largest mean of v over 0.1 s
///            runout                  m, sliding distance at the end
///   all      duration                s, end of the record; for a slide on the global clock
///   DEM      grains, steps, grain_steps   1
///            processor_seconds       s, time of straining the sample only, without preparation and records
///            steps_per_second        1/s
std::vector<Metric> scene_metrics(const SlideOutcome& outcome);

}  // namespace flowslide
