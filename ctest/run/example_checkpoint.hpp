// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cmath>
#include <type_traits>
#include <vector>

#include "record/example.hpp"
#include "record/hash.hpp"
#include "run/checkpoint.hpp"

namespace flowslide {

/// The state of a slide. All numbers are different, so that a mix-up shows.
inline Checkpoint example_checkpoint() {
  Checkpoint checkpoint;
  checkpoint.partial_result = example_result();
  checkpoint.partial_result.configuration_hash = hash_of(checkpoint.partial_result.configuration);
  checkpoint.share_done = 0.375;
  checkpoint.sample = {{{"time", 0.1}, {"steps", 12345.0}, {"shear_stress", 1.0 / 3.0}}, example_assembly()};
  SlideCheckpoint slide;
  SlideState& s = slide.state;
  s.exchanges = 5201;
  double number = 1.0;
  for (double* member : {&s.time, &s.sliding.displacement, &s.sliding.velocity, &s.velocity, &s.largest_velocity,
                         &s.strain.shear, &s.strain.compression, &s.owed.shear, &s.owed.compression, &s.driving_stress,
                         &s.stress.shear, &s.stress.normal, &s.global_rate, &s.rate_asked, &s.rate_applied,
                         &s.local_time, &s.rest.probed, &s.rest.rested, &s.adaptive.time_step})
    *member = std::sin(number += 1.0) / 3.0;
  s.steps = 17;
  s.unmeasured_runs = 3;
  s.adaptive.steps = 1234;
  s.local_steps = 987654321;
  slide.spacing = {0.25, std::numeric_limits<double>::infinity(), 77};
  slide.next_time = 0.52;
  slide.next_strain = 0.1 + 0.2;
  slide.profiles = {{{{0.01, 0.02}, {0.03, 0.04}, {0.05, 0.06}, 0.07, 0.08, 0.09},
                     {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}, 0.7, 0.8, 0.9},
                     3},
                    {{{1.1, 1.2}, {1.3, 1.4}, {1.5, 1.6}, 1, 2, 3}, {{1.1, 1.2}, {1.3, 1.4}, {1.5, 1.6}, 1, 2, 3}, 1}};
  slide.complete_profiles.axis = {"height", "z/H", "1", "relative height", "", {0.25, 0.75}};
  slide.complete_profiles.columns = {{"velocity_1", "<v_x>/v_top", "1", "velocity", "", {0.1 / 0.7, 0.2 / 0.7}}};
  ExchangeRecord& exchanges = slide.exchanges;
  exchanges = ExchangeRecord({}, 0.01);
  for_each_number_of(exchanges, [&](const char*, auto& member) {
    member = static_cast<std::remove_reference_t<decltype(member)>>(10.0 * (number += 1.0));
  });
  for (WindowRecord* windows : {&exchanges.over_time, &exchanges.over_strain, &exchanges.over_displacement})
    for (int point = 0; point < 4; ++point)
      windows->add(0.7 * windows->width * point,
                   std::vector<double>(windows->means.columns.size(), std::sin(number += 1.0)));
  checkpoint.slide = slide;
  checkpoint.measured = example_series(5);
  checkpoint.shots = {{0.125, 0.05, example_assembly(7)}};
  return checkpoint;
}

}  // namespace flowslide
