// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "program/runout.hpp"

namespace flowslide {
namespace {

constexpr double liquefied = 0.1;          ///< sigma / initial sigma at which a sample counts as liquefied
constexpr double half = 0.5;               ///< strain
constexpr double half_width = 5e-3;        ///< half width of the window around this strain
constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

struct Peak {
  double place, value;
};

/// The peak of `values` over `at`. `place` is the abscissa of the row with the largest value. A parabola through this
/// row and its neighbours refines the peak.
Peak refined_peak(const std::vector<double>& at, const std::vector<double>& values, double place) {
  const auto top = static_cast<std::size_t>(std::find(at.begin(), at.end(), place) - at.begin());
  if (top == at.size()) return {undefined, undefined};
  if (top == 0 || top + 1 == values.size()) return {at[top], values[top]};
  const double left = at[top - 1] - at[top], right = at[top + 1] - at[top];
  const double down = (values[top - 1] - values[top]) / left, up = (values[top + 1] - values[top]) / right;
  const double curvature = (up - down) / (right - left), slope = down - curvature * left;
  if (!(curvature < 0.0)) return {at[top], values[top]};
  const double shift = std::clamp(-0.5 * slope / curvature, left, right);
  return {at[top] + shift, values[top] + shift * (slope + shift * curvature)};
}

/// The abscissa `at` where `values` first falls to `level`, by linear interpolation; NaN if it does not. The first
/// value must be above `level`.
double first_fall(const std::vector<double>& at, const std::vector<double>& values, double level) {
  for (std::size_t row = 1; row < values.size(); ++row) {
    if (values[row] > level) continue;
    const double share = (level - values[row - 1]) / (values[row] - values[row - 1]);
    return at[row - 1] + share * (at[row] - at[row - 1]);
  }
  return undefined;
}

std::vector<Metric> element_metrics(const Series& series, const RunMeasures& measures) {
  const auto column = [&](const char* name) -> const std::vector<double>& { return series.column(name).values; };
  const auto& strain = column("shear_strain");
  const Peak peak = refined_peak(strain, column("shear_stress"), measures.peak_to_2.strain);
  const auto& normal = column("normal_stress");
  return {{"peak_shear_stress", peak.value, "Pa", "largest shear stress up to 2 % strain"},
          {"strain_at_peak", peak.place, "1", "shear strain at that stress"},
          {"strain_at_liquefaction", first_fall(strain, normal, liquefied * normal.front()), "1",
           "shear strain where sigma falls below a tenth of what it was"}};
}

std::vector<Metric> trigger_metrics(const RunMeasures& measures) {
  const bool reached = end_of(measures.over_strain) >= half + half_width;
  const double velocity = mean_over(measures.over_strain, "velocity", half - half_width, half + half_width);
  return {{"instability_time", measures.peak_to_2.time, "s", "time of the largest shear stress up to 2 % strain"},
          {"velocity_at_half", reached ? velocity : undefined, "m/s", "sliding velocity at 50 % strain"}};
}

std::vector<Metric> pulse_metrics(const SlideOutcome& outcome) {
  return {{"largest_velocity", largest_velocity(outcome.measures.over_time), "m/s",
           "largest sliding velocity, as a mean over 0.1 s"},
          {"runout", outcome.series.last("displacement"), "m", "sliding distance at the end"}};
}

}  // namespace

std::string name_of(Scene scene) {
  return scene == Scene::element ? "element" : scene == Scene::trigger ? "trigger" : "pulse";
}

Scene scene_of(const SlidePoint& point) {
  if (point.test) return Scene::element;
  return std::holds_alternative<SinePulse>(point.settings.loading) ? Scene::pulse : Scene::trigger;
}

std::vector<std::string> quantities_of(Scene scene) {
  if (scene == Scene::element) return {"peak_shear_stress", "strain_at_peak", "strain_at_liquefaction"};
  if (scene == Scene::trigger) return {"instability_time", "velocity_at_half"};
  return {"largest_velocity", "runout"};
}

std::vector<Metric> scene_metrics(const SlideOutcome& outcome) {
  const Scene scene = scene_of(outcome.point);
  std::vector<Metric> metrics = scene == Scene::element   ? element_metrics(outcome.series, outcome.measures)
                                : scene == Scene::trigger ? trigger_metrics(outcome.measures)
                                                          : pulse_metrics(outcome);
  metrics.push_back({"duration", outcome.series.last("time"), "s", "end of the record"});
  if (outcome.grains == nullptr) return metrics;
  const auto grains = static_cast<double>(outcome.grains->size());
  const auto steps = static_cast<double>(outcome.grains->steps());
  const double seconds = outcome.grains->processor_seconds();
  metrics.push_back({"grains", grains, "1", "number of grains"});
  metrics.push_back({"steps", steps, "1", "DEM steps"});
  metrics.push_back({"grain_steps", grains * steps, "1", "grains times DEM steps"});
  metrics.push_back({"processor_seconds", seconds, "s", "processor time of straining the sample"});
  metrics.push_back({"steps_per_second", steps / seconds, "1/s", "DEM steps per second of processor time"});
  return metrics;
}

}  // namespace flowslide
