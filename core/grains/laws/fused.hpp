// SPDX-License-Identifier: GPL-2.0-or-later
//
// Sums of products with fused operations: product and sum have one common rounding (IEEE 754, 5.4.1). They are written
// explicitly, so that all compilers give the same bits, at no loss of speed. For a processor without such an operation
// the C library computes it with the same bits, but slowly.
//
// The functions here and in the parts of a law are compiled for several instruction sets. They are always inline, so
// that no copy for wide vectors can be linked into other code.
#pragma once
#include <cmath>

#define FLOWSLIDE_LANE [[gnu::always_inline]] inline

namespace flowslide::laws {

/// A vector of one contact, by components.
template <typename Real>
struct Components {
  Real x = 0, y = 0, z = 0;
};

/// a b - c d
template <typename Real>
FLOWSLIDE_LANE Real difference_of_products(Real a, Real b, Real c, Real d) {
  return std::fma(a, b, -(c * d));
}

/// The scalar product.
template <typename Real>
FLOWSLIDE_LANE Real dot(const Components<Real>& a, const Components<Real>& b) {
  return std::fma(a.z, b.z, std::fma(a.y, b.y, a.x * b.x));
}

/// The vector product a x b.
template <typename Real>
FLOWSLIDE_LANE Components<Real> cross(const Components<Real>& a, const Components<Real>& b) {
  return {difference_of_products(b.z, a.y, b.y, a.z), difference_of_products(b.x, a.z, b.z, a.x),
          difference_of_products(b.y, a.x, b.x, a.y)};
}

/// a + factor b
template <typename Real>
FLOWSLIDE_LANE Components<Real> add_scaled(const Components<Real>& a, Real factor, const Components<Real>& b) {
  return {std::fma(factor, b.x, a.x), std::fma(factor, b.y, a.y), std::fma(factor, b.z, a.z)};
}

/// a minus its part along the unit vector n.
template <typename Real>
FLOWSLIDE_LANE Components<Real> across(const Components<Real>& a, const Components<Real>& n) {
  return add_scaled(a, -dot(a, n), n);
}

template <typename Real>
FLOWSLIDE_LANE Components<Real> operator-(const Components<Real>& a, const Components<Real>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename Real>
FLOWSLIDE_LANE Components<Real> operator*(Real factor, const Components<Real>& a) {
  return {a.x * factor, a.y * factor, a.z * factor};
}

/// p a - q b
template <typename Real>
FLOWSLIDE_LANE Components<Real> difference(Real p, const Components<Real>& a, Real q, const Components<Real>& b) {
  return {difference_of_products(p, a.x, q, b.x), difference_of_products(p, a.y, q, b.y),
          difference_of_products(p, a.z, q, b.z)};
}

}  // namespace flowslide::laws
