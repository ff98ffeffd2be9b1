// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/displacement_check.hpp"

#include <algorithm>

namespace flowslide::native {

template <typename Real>
void StrayWatch<Real>::start(const Share& share, const std::vector<Body<double>>& bodies,
                             const std::vector<double>& allowance) {
  start_.resize(allowance.size());
  for (std::size_t i = share.begin; i < share.end; ++i) {
    const double* x = bodies[i].position;
    start_[i] = {{x[0], x[1], x[2]}, allowance[i]};
  }
  slack_ = *std::min_element(allowance.begin(), allowance.end());
  drift_ = {};
  age_ = 0;
  compressed_ = measures_ = false;
}

template <typename Real>
bool StrayWatch<Real>::spend(double pace, double measured, double reach, bool compressed) {
  ++age_;
  slack_ = measures_ ? measured - 0.5 * reach * drift_.steepness() : slack_ - pace;
  const bool exhausted = measures_ && slack_ < 4.0 * pace;  // a measurement at every step costs more than a new list
  compressed_ = compressed_ || compressed;
  measures_ = !compressed_ && slack_ < 2.0 * pace;
  return exhausted || !(slack_ > 0.0);
}

template class StrayWatch<double>;
template class StrayWatch<float>;

}  // namespace flowslide::native
