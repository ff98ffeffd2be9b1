// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/displacement_check.hpp"

#include <algorithm>

namespace flowslide::native {

template <typename Real>
void DisplacementCheck<Real>::start(const GrainRange& range, const std::vector<Body<double>>& bodies,
                                    const std::vector<double>& allowance) {
  start_.resize(allowance.size());
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const double* x = bodies[i].position;
    start_[i] = {{x[0], x[1], x[2]}, allowance[i]};
  }
  slack_ = *std::min_element(allowance.begin(), allowance.end());
  drift_ = {};
  age_ = 0;
  compressed_ = measures_ = false;
}

template <typename Real>
bool DisplacementCheck<Real>::advance(double largest_growth, double measured, double reach, bool compressed) {
  ++age_;
  slack_ = measures_ ? measured - 0.5 * reach * drift_.steepness() : slack_ - largest_growth;
  const bool exhausted =
      measures_ && slack_ < 4.0 * largest_growth;  // a measurement at every step costs more than a new list
  compressed_ = compressed_ || compressed;
  measures_ = !compressed_ && slack_ < 2.0 * largest_growth;
  return exhausted || !(slack_ > 0.0);
}

template class DisplacementCheck<double>;
template class DisplacementCheck<float>;

}  // namespace flowslide::native
