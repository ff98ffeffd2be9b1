// SPDX-License-Identifier: GPL-2.0-or-later
#include "experiment/slide_run.hpp"

#include <algorithm>
#include <array>

namespace flowslide {
namespace {

void append_row(SlideRecord& record, const Slide& slide) {
  const SlideState& state = slide.state();
  const ExchangeRecord& exchanges = record.exchanges;
  const bool measured = exchanges.mean_stress_time == state.time;
  const double mean = measured ? exchanges.mean_stress : slide.sample().mean_stress();
  const std::array values{state.sliding.displacement,
                          state.velocity,
                          state.strain.shear,
                          state.strain.compression,
                          state.stress.shear,
                          state.stress.normal,
                          mean,
                          slide.basal_pore_pressure(),
                          state.driving_stress,
                          state.global_rate,
                          state.rate_asked,
                          state.rate_applied,
                          number_at(state.rate_applied, mean, record.grains),
                          number_at(state.global_rate, mean, record.grains),
                          slide.sample().void_ratio(),
                          state.local_time,
                          static_cast<double>(state.local_steps)};
  record.series.append_row(state.time, values);
}

/// Keeps every second value, starting with the first.
void halve(std::vector<double>& values) {
  for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
  values.resize((values.size() + 1) / 2);
}

void thin_out(SlideRecord& record) {
  halve(record.series.axis.values);
  for (Column& column : record.series.columns) halve(column.values);
  record.spacing.interval *= 2.0;
  record.spacing.strain *= 2.0;
}

}  // namespace

Stop run_slide(Slide& slide, const StopConditions& conditions, SlideRecord& record, const StepObserver& go_on) {
  validate(conditions);
  const SlideState& state = slide.state();
  const auto mark = [&] {
    record.next_time = next_multiple(state.time, record.spacing.interval);
    record.next_strain = next_multiple(std::max(state.strain.shear, 0.0), record.spacing.strain);
  };
  const auto take_row = [&] {
    if (static_cast<std::int64_t>(record.series.rows()) >= record.spacing.most_rows) thin_out(record);
    append_row(record, slide);
    mark();
  };
  if (record.exchanges.taken == 0) record.exchanges.take(slide);
  if (record.series.rows() == 0) take_row();
  for (;;) {
    const Stop stop = stop_of(state, conditions, slide.settings().time_step);
    if (stop != Stop::not_yet) {
      if (record.series.axis.values.back() < state.time) take_row();
      return stop;
    }
    slide.step();
    record.exchanges.take(slide);
    if (state.time >= record.next_time || state.strain.shear >= record.next_strain) take_row();
    if (go_on && !go_on(state)) return Stop::not_yet;
  }
}

}  // namespace flowslide
