// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

namespace flowslide {

struct TimeStepError {
  double time_step = 0.0;  ///< s
  double error = 0.0;      ///< against a run at the reference step
};

/// Order of accuracy p: the error against a reference that is itself not exact goes as step^p - reference^p. The p for
/// which the two largest steps above the reference are to each other as that; not a number for fewer than two, for
/// equal ones, or if an error is 0 or missing, or no p from 0.1 to 6 fits.
double order_of_accuracy(std::vector<TimeStepError> errors, double reference_step);

}  // namespace flowslide
