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

/// Called after each global step, for progress, profiles and signals. Returns false to end the run. It must be cheap.
using StepObserver = std::function<bool(const SlideState&)>;

/// Steps a slide until one of the conditions is met, and records it. Returns this condition. Returns Stop::not_yet if
/// `go_on` ended the run; then the present state gets no row. The mean stress of a row is that of the bulk of the
/// sample (see Sample::mean_stress). A row has two inertial numbers with this mean stress: of the strain rate applied
/// to the sample, and of the strain rate of the slope. In RI they differ. Throws NumericalFailure, and
/// std::invalid_argument if the conditions are not valid.
Stop run_slide(Slide& slide, const StopConditions& conditions, SlideRecord& record, const StepObserver& go_on = {});

}  // namespace flowslide
