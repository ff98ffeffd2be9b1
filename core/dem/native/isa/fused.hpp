// SPDX-License-Identifier: GPL-2.0-or-later
//
// Sums of products, each product fused with its sum into one operation with one rounding (IEEE 754, 5.4.1), written out
// by us instead of left to the compiler: as fast as what it would find, and with the same bits from all of them. A
// processor without such an operation gets it from the C library, with the same bits, slowly.
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
