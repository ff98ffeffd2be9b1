// SPDX-License-Identifier: GPL-2.0-or-later
// A slope on the elastic sample: a swing with an exact solution.
#pragma once
#include <cmath>

#include "coupling/slide.hpp"
#include "sample/elastic_sample.hpp"

namespace flowslide {

/// A sample in balance with a slope but for a share of its normal stress.
inline ElasticProperties elastic_for(const SlopeProperties& slope, double normal_share = 1.0) {
  ElasticProperties properties;
  properties.shear_stress = initial_shear_stress(slope);
  properties.normal_stress = normal_share * initial_normal_stress(slope);
  return properties;
}

/// omega = sqrt(G/(h_s m)), rad/s.
inline double frequency(const SlopeProperties& slope, const ElasticProperties& sample) {
  return std::sqrt(sample.shear_modulus / (slope.liquefiable_thickness * mass_per_area(slope)));
}

/// x and v of a slide that starts in balance with the velocity v0 (m/s): m x'' + (eta/h_s) x' + (G/h_s) x = 0.
struct Swing {
  double displacement, velocity;
};
inline Swing exact_swing(const SlopeProperties& slope, const ElasticProperties& sample, double v0, double time) {
  const double decay = sample.viscosity / (2.0 * slope.liquefiable_thickness * mass_per_area(slope));
  const double omega = frequency(slope, sample), damped = std::sqrt(omega * omega - decay * decay);
  const double envelope = v0 * std::exp(-decay * time), s = std::sin(damped * time), c = std::cos(damped * time);
  return {envelope * s / damped, envelope * (c - decay / damped * s)};
}

inline void run_until(Slide& slide, double end_time) {
  while (slide.state().time < end_time - 0.5 * slide.settings().time_step) slide.step();
}

}  // namespace flowslide
