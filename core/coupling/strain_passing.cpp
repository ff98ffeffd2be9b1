// SPDX-License-Identifier: GPL-2.0-or-later
#include "coupling/strain_passing.hpp"

#include <algorithm>
#include <cmath>

#include "grains/require.hpp"

namespace flowslide {
namespace {

/// Fraction of a step by which q may be below a whole number and still count as this number. q is a quotient of rounded
/// numbers: their last bits must not decide whether a step runs now or one exchange later.
constexpr double rounding_of_steps = 1e-9;

/// floor(steps) + surplus, at most `most`. `steps` is infinite at a rate of 0.
std::int64_t whole_steps(double steps, std::int64_t surplus, std::int64_t most) {
  if (!(steps < static_cast<double>(most))) return most;
  return std::min(static_cast<std::int64_t>(std::floor(steps)) + surplus, most);
}

/// Passes all of `owed` in `steps` steps of `time_step` (s).
LocalRun pass_all(Strain& owed, std::int64_t steps, double time_step) {
  const double duration = static_cast<double>(steps) * time_step;
  const LocalRun run{{owed.shear / duration, owed.compression / duration}, steps, time_step};
  owed = {};
  return run;
}

LocalRun take(const AccumulateAndReset& rule, const StrainPassing& passing, Strain& owed, double asked) {
  const double norm = owed.norm();
  if (norm == 0.0) return {};
  const std::int64_t steps = whole_steps(norm / (asked * passing.time_step), 1, passing.most_steps);
  return steps < rule.least_steps ? LocalRun{} : pass_all(owed, steps, passing.time_step);
}

LocalRun take(const WholeIncrement&, const StrainPassing& passing, Strain& owed, double asked) {
  return take(AccumulateAndReset{1}, passing, owed, asked);
}

LocalRun take(const CarryRemainder& rule, const StrainPassing& passing, Strain& owed, double asked) {
  const double norm = owed.norm();
  if (norm == 0.0 || asked == 0.0) return {};  // at a rate of 0 no strain can be passed
  const double wanted = norm / (asked * passing.time_step);
  const std::int64_t steps = whole_steps(wanted + rounding_of_steps, 0, passing.most_steps);
  if (steps < rule.least_steps) return {};
  const Strain direction = (1.0 / norm) * owed;
  owed = (1.0 - static_cast<double>(steps) / wanted) * owed;
  return {{asked * direction.shear, asked * direction.compression}, steps, passing.time_step};
}

LocalRun take(const VariableTimeStep&, const StrainPassing& passing, Strain& owed, double asked) {
  const double norm = owed.norm();
  if (norm == 0.0) return {};
  const double duration = norm / asked;
  const std::int64_t steps = whole_steps(duration / passing.time_step, 1, passing.most_steps);
  return pass_all(owed, steps, std::min(duration / static_cast<double>(steps), passing.time_step));
}

std::int64_t least_steps(const StrainPassing& passing) {
  if (const auto* reset = std::get_if<AccumulateAndReset>(&passing.rule)) return reset->least_steps;
  if (const auto* carry = std::get_if<CarryRemainder>(&passing.rule)) return carry->least_steps;
  return 1;
}

}  // namespace

void validate(const StrainPassing& passing) {
  require(passing.time_step > 0.0, "time step dt_L", passing.time_step, "> 0 s", "Give one such as 1e-5 s.");
  const std::int64_t least = least_steps(passing);
  require(least >= 1, "n_accum", static_cast<double>(least), "1 or more", "The paper has 10; 1 is eq. 15.");
  require(passing.most_steps >= least, "largest number of steps per exchange",
          static_cast<double>(passing.most_steps), "n_accum or more", "Allow more steps.");
}

LocalRun pass(const StrainPassing& passing, Strain& owed, const Strain& increment, double asked) {
  owed += increment;
  return std::visit([&](const auto& rule) { return take(rule, passing, owed, asked); }, passing.rule);
}

}  // namespace flowslide
