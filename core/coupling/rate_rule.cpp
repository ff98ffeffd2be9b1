// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/rate_rule.hpp"

#include <algorithm>
#include <cmath>

#include "grains/measures.hpp"
#include "grains/require.hpp"

namespace flowslide {
namespace {

void check(double inertial_number, const GrainScale& grains) {
  require(inertial_number > 0.0, "inertial number to shear at", inertial_number, "> 0", "1e-4 is quasi-static.");
  require(grains.mean_diameter > 0.0, "mean diameter", grains.mean_diameter, "> 0 m", "Give that of the sample.");
  require(grains.density > 0.0, "density", grains.density, "> 0 kg/m^3", "Give the density of the solid.");
}

void check(const GlobalRate&) {}

void check(const ConstantStrainRate& rule) {
  require(rule.rate > 0.0, "strain rate to shear at", rule.rate, "> 0 1/s", "0.06 1/s is quasi-static.");
}

void check(const ConstantInertialNumber& rule) {
  check(rule.inertial_number, rule.grains);
  require(rule.smallest_rate >= 0.0, "smallest strain rate", rule.smallest_rate, ">= 0 1/s",
          "It bounds the time that a liquefied sample takes.");
  require(rule.smallest_rate_from >= 0.0, "strain from which the floor is the smallest strain rate",
          rule.smallest_rate_from, ">= 0", "0 lets it hold from the start.");
}

void check(const GlobalRateAtLeastQuasiStatic& rule) { check(rule.inertial_number, rule.grains); }

double rate_at(double inertial_number, const GrainScale& grains, double pressure) {
  if (!(pressure > 0.0)) return 0.0;
  return shear_rate_for(inertial_number, grains.mean_diameter, grains.density, pressure);
}

double asked(const GlobalRate&, double global_rate, double, double) { return global_rate; }

double asked(const ConstantStrainRate& rule, double, double, double) { return rule.rate; }

double asked(const ConstantInertialNumber& rule, double, double pressure, double shear_strain) {
  const double strain = std::abs(shear_strain);
  const double share = strain < rule.smallest_rate_from ? strain / rule.smallest_rate_from : 1.0;
  return std::max(rate_at(rule.inertial_number, rule.grains, pressure), rule.smallest_rate * share * share);
}

double asked(const GlobalRateAtLeastQuasiStatic& rule, double global_rate, double pressure, double) {
  return std::max(global_rate, rate_at(rule.inertial_number, rule.grains, pressure));
}

RateRule with_grains(const GlobalRate& rule, const GrainScale&, double) { return rule; }

RateRule with_grains(ConstantStrainRate rule, const GrainScale& grains, double pressure) {
  if (rule.inertial_number > 0.0) rule.rate = rate_at(rule.inertial_number, grains, pressure);
  return rule;
}

RateRule with_grains(ConstantInertialNumber rule, const GrainScale& grains, double) {
  rule.grains = grains;
  return rule;
}

RateRule with_grains(GlobalRateAtLeastQuasiStatic rule, const GrainScale& grains, double) {
  rule.grains = grains;
  return rule;
}

}  // namespace

RateRule for_grains(const RateRule& rule, const GrainScale& grains, double initial_normal_stress) {
  return std::visit([&](const auto& kind) { return with_grains(kind, grains, initial_normal_stress); }, rule);
}

void validate(const RateRule& rule) {
  std::visit([](const auto& kind) { check(kind); }, rule);
}

double rate_asked(const RateRule& rule, double global_rate, double pressure, double shear_strain) {
  return std::visit([=](const auto& kind) { return asked(kind, global_rate, pressure, shear_strain); }, rule);
}

}  // namespace flowslide
