// SPDX-License-Identifier: GPL-2.0-or-later
// How strain passes from the slope to the sample: the strain of a global step becomes local steps at a strain rate.
// d = ||d(epsilon_G)|| is the strain to be passed, r = eps_L^U the rate asked for (1/s), T = d/r the local time and
// q = T/dt_L the number of local steps that this takes.
//
//   rule                n_step                 rate applied      strain passed      excess of local time over T
//   WholeIncrement      floor(q) + 1           r q/(floor(q)+1)  all, at once       up to one step per exchange
//   AccumulateAndReset  the same, >= n_accum   the same          all, when it runs  up to one step per run
//   CarryRemainder      floor(q) >= n_accum    r                 in whole steps     none
//   VariableTimeStep    floor(T/dt_L^U) + 1    r                 all, at once       none
//
// No rule runs more than `most_steps` per exchange. The rate asked for may need more when v crosses zero (r tends to 0
// while strain is owed) or when sigma vanishes. CarryRemainder then keeps the remainder for later. The other rules pass
// all strain faster than asked; SlideState::rate_applied shows this.
#pragma once
#include <cstdint>
#include <variant>

#include "coupling/strain.hpp"
#include "sample/sample.hpp"

namespace flowslide {

/// Eq. 15: n_step = floor(||d(epsilon_G)||/(eps_L^U dt_L)) + 1, t_DEM = n_step dt_L, rate = d(epsilon_G)/t_DEM. For a
/// small dt_G the rate is lower than the rate asked for (eq. 16b). Without strain eq. 15 is 0/0, and no step runs.
struct WholeIncrement {};

/// Eq. 18 as printed: strain accumulates until n_step = floor(||eps_accum||/(eps_L^U dt_L)) + 1 >= n_accum. Then n_step
/// steps pass all of it, and eps_accum is reset to zero. n_accum = 1 is eq. 15. The rate applied is q/(floor(q) + 1)
/// times the rate asked for: too low by the fraction 1/(n_accum + 1) at q = n_accum, and by 1/n_accum at worst.
struct AccumulateAndReset {
  std::int64_t least_steps = 10;  ///< n_accum, >= 1
};

/// Eq. 18 with the remainder carried: once n_step = floor(q) >= n_accum, n_step steps run at exactly the rate asked
/// for, with q = ||eps_accum||/(eps_L^U dt_L). The strain of the fraction of a step stays in eps_accum, with its sign.
/// The strain passed and the local time are exact.
struct CarryRemainder {
  std::int64_t least_steps = 10;  ///< n_accum, >= 1
};

/// Eq. 17: t_DEM = ||d(epsilon_G)||/eps_L^U, n_step = floor(t_DEM/dt_L^U) + 1, dt_L = t_DEM/n_step.
struct VariableTimeStep {};

using PassingRule = std::variant<WholeIncrement, AccumulateAndReset, CarryRemainder, VariableTimeStep>;

struct StrainPassing {
  PassingRule rule = CarryRemainder{};
  double time_step = 5e-7;            ///< dt_L, s; for VariableTimeStep the largest one, dt_L^U
  std::int64_t most_steps = 100'000;  ///< largest number of local steps per exchange, >= n_accum
};

/// Throws std::invalid_argument if a value is out of its range.
void validate(const StrainPassing& passing);

/// Adds `increment` to the strain `owed` to the sample. Then removes from it the strain that is passed now, and returns
/// the run that passes this strain. `asked` is the rate asked for (1/s, >= 0). With 0 steps the sample waits.
LocalRun pass(const StrainPassing& passing, Strain& owed, const Strain& increment, double asked);

}  // namespace flowslide
