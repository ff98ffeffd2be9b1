// SPDX-License-Identifier: GPL-2.0-or-later
// How strain passes from the slope to the sample: the increment of one global step becomes local steps at a rate. With
// d = ||d(epsilon_G)||, r = eps_L^U the rate asked for (1/s) and q = d/(r dt_L) the steps that this would take:
//
//   rule                n_step                 rate applied      strain passed       local clock per strain
//   WholeIncrement      floor(q) + 1           r q/(floor(q)+1)  all, at once        up to one step too much
//   AccumulateAndReset  the same, >= n_accum   the same          all, when it runs   the same, once per n_accum
//   CarryRemainder      floor(q) >= n_accum    r                 whole steps' worth  exact
//   VariableTimeStep    floor(T/dt_L^U) + 1    r                 all, at once        exact
//
// No rule runs more than `most_steps` per exchange, which the rate asked for would need when v crosses zero (r tends to
// 0 while strain is owed) or sigma does. Then CarryRemainder keeps the rest for later; the others pass all of it
// faster than asked, which the rate applied tells.
#pragma once
#include <cstdint>
#include <variant>

#include "coupling/strain.hpp"
#include "sample/sample.hpp"

namespace flowslide {

/// Eq. 15: n_step = floor(||d(epsilon_G)||/(eps_L^U dt_L)) + 1, t_DEM = n_step dt_L, rate = d(epsilon_G)/t_DEM. The
/// rate falls short of the one asked for as dt_G becomes small (eq. 16b). Without strain there is nothing to run, where
/// eq. 15 is 0/0.
struct WholeIncrement {};

/// Eq. 18 as printed: strain accumulates until n_step = floor(||eps_accum||/(eps_L^U dt_L)) + 1 >= n_accum; then all of
/// it is passed in n_step steps and eps_accum is reset to zero. n_accum = 1 is eq. 15. The rate is q/(floor(q) + 1) of
/// the one asked for: low by 1/(n_accum + 1) where q meets n_accum, and by 1/n_accum at worst.
struct AccumulateAndReset {
  std::int64_t least_steps = 10;  ///< n_accum, >= 1
};

/// Eq. 18 with the remainder carried: n_step = floor(q) steps at exactly the rate asked for once there are n_accum of
/// them, q = ||eps_accum||/(eps_L^U dt_L); the strain of the broken step stays in eps_accum, with its sign. Strain is
/// neither lost nor added, and the local clock runs neither fast nor slow.
struct CarryRemainder {
  std::int64_t least_steps = 10;  ///< n_accum, >= 1
};

/// Eq. 17: t_DEM = ||d(epsilon_G)||/eps_L^U, n_step = floor(t_DEM/dt_L^U) + 1, dt_L = t_DEM/n_step.
struct VariableTimeStep {};

using PassingRule = std::variant<WholeIncrement, AccumulateAndReset, CarryRemainder, VariableTimeStep>;

struct StrainPassing {
  PassingRule rule = CarryRemainder{};
  double time_step = 5e-7;            ///< dt_L, s; the largest one (dt_L^U) for VariableTimeStep
  std::int64_t most_steps = 100'000;  ///< of one exchange, >= n_accum
};

/// Throws std::invalid_argument if a value is out of its range.
void validate(const StrainPassing& passing);

/// Adds `increment` to the strain `owed` to the sample, and takes from it what is to be passed now, at the rate `asked`
/// (1/s, >= 0). No steps: the sample waits.
LocalRun pass(const StrainPassing& passing, Strain& owed, const Strain& increment, double asked);

}  // namespace flowslide
