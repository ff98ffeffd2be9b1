// SPDX-License-Identifier: GPL-2.0-or-later
//
// Sums of products with fused operations: product and sum have one common rounding (IEEE 754, 5.4.1). They are written
// explicitly, so that all compilers give the same bits, at no loss of speed. For a processor without such an operation
// the C library computes it with the same bits, but slowly.
#pragma once
#include <cmath>

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// a b - c d
template <typename Real>
inline Real difference_of_products(Real a, Real b, Real c, Real d) {
  return std::fma(a, b, -(c * d));
}

/// The scalar product of (ax, ay, az) and (bx, by, bz).
template <typename Real>
inline Real dot(Real ax, Real ay, Real az, Real bx, Real by, Real bz) {
  return std::fma(az, bz, std::fma(ay, by, ax * bx));
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
