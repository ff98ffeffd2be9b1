// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/slide_run.hpp"

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

/// Keeps every second value, the first among them.
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

Series slide_series() {
  const char* shear = "positive downslope";
  const char* compression = "compression positive";
  Series series;
  series.columns = {
      {"displacement", "x", "m", "sliding distance", shear, {}},
      {"velocity", "v", "m/s", "sliding velocity", shear, {}},
      {"shear_strain", "gamma", "1", "shear strain of the liquefiable layer", shear, {}},
      {"volumetric_strain", "epsilon", "1", "volumetric strain of the layer by drainage", compression, {}},
      {"shear_stress", "tau", "Pa", "resisting shear stress", shear, {}},
      {"normal_stress", "sigma", "Pa", "effective normal stress", compression, {}},
      {"mean_stress", "p", "Pa", "mean stress away from the glued layers, with the kinetic part", compression, {}},
      {"pore_pressure", "p_w", "Pa", "excess pore pressure at the base", "positive above hydrostatic", {}},
      {"driving_stress", "tau_d", "Pa", "driving shear stress", shear, {}},
      {"global_rate", "eps_G", "1/s", "strain rate of the slope", "", {}},
      {"rate_asked", "eps_L^U", "1/s", "strain rate asked for of the sample", "", {}},
      {"rate_applied", "eps_L", "1/s", "strain rate that the sample was last sheared at", "", {}},
      {"inertial_number", "I", "1", "inertial number of the rate applied", "", {}},
      {"global_inertial_number", "I_G", "1", "inertial number of the rate of the slope", "", {}},
      {"void_ratio", "e", "1", "void ratio of the sample", "", {}},
      {"local_time", "t_L", "s", "local clock", "", {}},
      {"local_steps", "n_L", "1", "local time steps so far", "", {}},
  };
  return series;
}

Stop run_slide(Slide& slide, const StopConditions& conditions, SlideRecord& record, const SlideHooks& hooks) {
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
    if (hooks.row) hooks.row(slide, record.series);
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
    if (hooks.go_on && !hooks.go_on(state)) return Stop::not_yet;
  }
}

}  // namespace flowslide
