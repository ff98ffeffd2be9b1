// SPDX-License-Identifier: GPL-2.0-or-later
#include "order_of_accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace flowslide {

double order_of_accuracy(std::vector<TimeStepError> errors, double reference_step) {
  constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
  std::erase_if(errors, [&](const TimeStepError& e) { return e.time_step <= reference_step; });
  if (errors.size() < 2) return nothing;
  std::sort(errors.begin(), errors.end(), [](const auto& a, const auto& b) { return a.time_step > b.time_step; });
  const TimeStepError &coarse = errors[0], &fine = errors[1];
  if (!(coarse.error > 0.0 && fine.error > 0.0 && coarse.time_step > fine.time_step)) return nothing;
  const auto excess = [&](double p) {
    const auto distance = [&](double step) { return std::pow(step / coarse.time_step, p) -
                                                    std::pow(reference_step / coarse.time_step, p); };
    return distance(coarse.time_step) / distance(fine.time_step) - coarse.error / fine.error;
  };
  double low = 0.1, high = 6.0;  // the ratio grows with p
  if (excess(low) > 0.0 || excess(high) < 0.0) return nothing;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace flowslide
