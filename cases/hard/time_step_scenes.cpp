// SPDX-License-Identifier: GPL-2.0-or-later
// The local time step: above its limit of stability, for grains of different stiffness, and while the stress rises.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "detectors.hpp"
#include "experiments.hpp"
#include "grains/measures.hpp"
#include "sample/health.hpp"
#include "scenes.hpp"

namespace flowslide {
namespace {

constexpr const char* time_step = "time step";  ///< text of every message that refuses a time step
constexpr const char* too_long = "too long for contacts";
constexpr int readings = 40;
constexpr double strain = 0.01;         ///< about the peak of loose samples; trajectories have not diverged by rounding
constexpr double small_strain = 0.006;  ///< the same for samples of any stiffness
constexpr double refined = 0.1;         ///< reference time step in Rayleigh times: 1.6e-6 s
constexpr double wrong = 0.05;          ///< relative error of the peak that no seed, rate or rolling parameter explains
constexpr std::array shares{0.1, 0.3, 0.5, 0.6, 0.64, 0.68, 0.72, 0.76, 0.8, 0.84, 0.9, 1.0, 1.25, 1.5, 2.0};

Series empty_scan() {
  Series scan;
  scan.axis = {"run", "i", "1", "run of the scan, from 1", "", {}};
  for (const char* name : {"sample", "rayleigh_share", "peak_ratio", "edge_share", "is_wrong", "by_stiffness",
                           "by_overlap", "by_rest", "by_energy", "grains"})
    scan.columns.push_back({name, "", "1", name, "", {}});
  scan.columns[1].long_name = "time step over the Rayleigh time of the smallest grain";
  scan.columns[2].long_name = "peak of the shear stress over that of a refined run";
  scan.columns[3].long_name = "time step as a share of the edge of stability (see time_step_share)";
  scan.columns.back().long_name = "number of grains of the sample";
  return scan;
}

/// Adds the number of misses and of false alarms of a detector in a scan.
void count_alarms(const Series& scan, const std::string& detector, std::vector<Metric>& metrics) {
  const auto &alarm = scan.column("by_" + detector).values, &is_wrong = scan.column("is_wrong").values;
  double missed = 0.0, needless = 0.0;
  for (std::size_t i = 0; i < scan.rows(); ++i) {
    missed += is_wrong[i] > alarm[i];
    needless += alarm[i] > is_wrong[i];
  }
  metrics.push_back({detector + "_misses", missed, "1", "wrong runs without an alarm"});
  metrics.push_back({detector + "_false_alarms", needless, "1", "alarms in runs whose peak is right"});
}

}  // namespace

SceneRecord time_step_scene(const SceneContext& context) {
  const Material& material = context.settings().material;
  const Shearing shearing{context.settings().shear_rate, strain, readings};
  SceneRecord record;
  record.details = empty_scan();
  for (std::int64_t number = 0; number < context.settings().seeds; ++number) {
    const Assembly sample = context.prepared(SceneContext::numbered(context.settings().loose, number)).assembly;
    const auto peak = [&](double share) {
      return peak_of(shear(context, sample, {material, time_step_of(share, sample, material)}, shearing));
    };
    const double right = peak(refined);
    for (const double share : shares) {
      record.trials.push_back(attempt(fmt::format("sample {}, dt_L = {} t_R", number + 1, share),
                                      relative(right, 0.01, wrong, share > 0.6 ? time_step : ""),
                                      [&] { return peak(share); }));
      const UncheckedRun run =
          run_unchecked(*context.engine(), sample, {material, time_step_of(share, sample, material)}, shearing);
      const bool is_wrong = run.lost || std::abs(run.peak / right - 1.0) > wrong;
      const std::array row{static_cast<double>(number + 1),
                           share,
                           run.peak / right,
                           run.largest_share,
                           is_wrong ? 1.0 : 0.0,
                           run.stiffness_alarm ? 1.0 : 0.0,
                           run.overlap_alarm ? 1.0 : 0.0,
                           run.rest_alarm ? 1.0 : 0.0,
                           run.energy_alarm ? 1.0 : 0.0,
                           static_cast<double>(sample.size())};
      record.details.append_row(static_cast<double>(record.details.rows() + 1), row);
    }
  }
  for (const char* detector : {"stiffness", "overlap", "rest", "energy"})
    count_alarms(record.details, detector, record.metrics);
  record.metrics.push_back({"runs", static_cast<double>(record.details.rows()), "1", "runs of the scan"});
  return record;
}

SceneRecord stiffness_scene(const SceneContext& context) {
  SceneRecord record;
  for (const double gigapascal : {0.1, 0.5, 2.0, 10.0, 70.0}) {
    SampleRecipe recipe = context.settings().loose;
    recipe.material.youngs_modulus = 1e9 * gigapascal;
    const double rayleigh = rayleigh_time(0.5 * recipe.packing.smallest_diameter, recipe.material);
    recipe.time_step = 0.45 * rayleigh;
    const Assembly sample = context.prepared(recipe).assembly;
    const auto peak = [&](double share) {
      return peak_of(shear(context, sample, {recipe.material, share * rayleigh},
                           {context.settings().shear_rate, small_strain, readings}));
    };
    const double right = peak(refined);
    for (const double share : {0.3, 0.64})
      record.trials.push_back(attempt(fmt::format("E = {} GPa, dt_L = {} t_R", gigapascal, share),
                                      relative(right, 0.01, wrong, share > 0.5 ? too_long : ""),
                                      [&] { return peak(share); }));
  }
  return record;
}

SceneRecord dilation_scene(const SceneContext& context) {
  constexpr double last = 0.12, from = 0.08;  // strain at the end, and strain from which the stress is averaged
  const Material& material = context.settings().material;
  const Assembly sample = context.prepared(context.settings().dense).assembly;
  const auto strength = [&](double step) {
    return mean_shear(shear(context, sample, {material, step}, {context.settings().shear_rate, last, 300}), from);
  };
  const double right = strength(2e-6);
  SceneRecord record;
  for (const double step : {4e-6, 6e-6, 8e-6, 1e-5})
    record.trials.push_back(attempt(fmt::format("dt_L = {:.0e} s", step),
                                    relative(right, 0.2, 0.4, step > 5e-6 ? too_long : ""),
                                    [&] { return strength(step); }));
  return record;
}

}  // namespace flowslide
