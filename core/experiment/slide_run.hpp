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

/// Where rows of the record are taken: whenever the clock or the shear strain of the layer passes a multiple. There are
/// never more than `most_rows`: then every second one is dropped and both distances are doubled.
struct RowSpacing {
  double interval = std::numeric_limits<double>::infinity();  ///< s
  double strain = std::numeric_limits<double>::infinity();    ///< gamma
  std::int64_t most_rows = 2000;                              ///< the first and the last always among them
};

/// The record of a slide. Kept with the slide's state and its sample, it goes on where it was.
struct SlideRecord {
  RowSpacing spacing{};              ///< as it is now
  GrainScale grains{};               ///< of the inertial number
  Series series = slide_series();
  double next_time = 0.0;            ///< where the next row is due, s
  double next_strain = 0.0;          ///< or here
  ExchangeRecord exchanges{};        ///< what metrics are made of, whatever rows are kept
};

/// Called after each global step, for progress, profiles and signals. false ends the run.
using StepObserver = std::function<bool(const SlideState&)>;

/// Steps a slide until a condition is met, and records it. Returns that condition, or Stop::not_yet if `go_on` ended
/// the run; only then there is no last row. The mean stress of a row is that of the sample's bulk (see Sample::mean_stress), and
/// its inertial numbers are built on it: of the rate applied, and of the rate of the slope, which in RI differ.
/// Throws NumericalFailure.
Stop run_slide(Slide& slide, const StopConditions& conditions, SlideRecord& record, const StepObserver& go_on = {});

}  // namespace flowslide
