// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <limits>

#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "experiment/run_measures.hpp"
#include "experiment/slide_series.hpp"
#include "record/series.hpp"

namespace flowslide {

/// Spacing of the rows of a record. A row is taken when the clock passes a multiple of `interval` or the shear strain
/// of the layer passes a multiple of `strain`. When `most_rows` is reached, every second row is dropped and both
/// distances are doubled.
struct RowSpacing {
  double interval = std::numeric_limits<double>::infinity();  ///< s
  double strain = std::numeric_limits<double>::infinity();    ///< gamma
  std::int64_t most_rows = 2000;                              ///< includes the first and the last row of the slide
};

/// The record of a slide. If it is restored together with the slide and its sample, it continues bit for bit.
struct SlideRecord {
  RowSpacing spacing{};              ///< present spacing, after all doublings
  GrainScale grains{};               ///< for the inertial numbers
  Series series = slide_series();
  double next_time = 0.0;            ///< a row is due at this time, s,
  double next_strain = 0.0;          ///< or at this shear strain
  ExchangeRecord exchanges{};        ///< data for metrics, independent of the rows kept
};

/// Called after each global step, for progress, profiles and signals. false ends the run.
using StepObserver = std::function<bool(const SlideState&)>;

/// Steps a slide until a condition is met, and records it. Returns that condition, or Stop::not_yet if `go_on` ended
/// the run; only then there is no last row. The mean stress of a row is that of the sample's bulk (see Sample::mean_stress), and
/// its inertial numbers are built on it: of the rate applied, and of the rate of the slope, which in RI differ.
/// Throws NumericalFailure.
Stop run_slide(Slide& slide, const StopConditions& conditions, SlideRecord& record, const StepObserver& go_on = {});

}  // namespace flowslide
