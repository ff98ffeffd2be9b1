// SPDX-License-Identifier: GPL-2.0-or-later
//
// Transposes rows (x, y, z, w) of several grains to columns of x, y and z, and back. A Band contains as many rows as
// the widest register; its rows belong to grains that are four lanes apart. A 4 x 4 transposition within each part of
// the band then transposes all rows.
#pragma once
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#include "dem/native/isa/row.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

#ifdef __AVX512F__
using DoubleBand = double __attribute__((vector_size(64), may_alias));
using FloatBand = float __attribute__((vector_size(64), may_alias));
#else
using DoubleBand = DoubleRow;
using FloatBand = FloatRow;
#endif
template <typename Real>
struct BandOf {
  using Type = DoubleBand;
};
template <>
struct BandOf<float> {
  using Type = FloatBand;
};
template <typename Real>
using Band = typename BandOf<Real>::Type;

/// Number of rows in a band, and number of lanes in four bands.
template <typename Real>
inline constexpr int rows_in_band = sizeof(Band<Real>) / sizeof(Row<Real>);
template <typename Real>
inline constexpr int lanes_of_bands = 4 * rows_in_band<Real>;

/// The rows that start at `numbers(0)`, `numbers(1)`, ... in one band.
template <typename Real, typename Numbers>
inline Band<Real> band_of(Numbers numbers) {
#ifdef __AVX512F__
  // Inserts from memory: the only port that can shuffle is then free for the transpositions.
  if constexpr (std::is_same_v<Real, double>)
    return _mm512_insertf64x4(_mm512_zextpd256_pd512(_mm256_load_pd(numbers(0))), _mm256_load_pd(numbers(1)), 1);
  else {
    __m512 band = _mm512_zextps128_ps512(_mm_load_ps(numbers(0)));
    band = _mm512_insertf32x4(band, _mm_load_ps(numbers(1)), 1);
    band = _mm512_insertf32x4(band, _mm_load_ps(numbers(2)), 2);
    return _mm512_insertf32x4(band, _mm_load_ps(numbers(3)), 3);
  }
#else
  return row_at(numbers(0));
#endif
}

/// Row `number` of a band.
template <int number>
inline DoubleRow row_of(DoubleRow band) {
  return band;
}
template <int number>
inline FloatRow row_of(FloatRow band) {
  return band;
}
#ifdef __AVX512F__
template <int number>
inline DoubleRow row_of(DoubleBand band) {
  constexpr int at = 4 * number;
  return __builtin_shufflevector(band, band, at, at + 1, at + 2, at + 3);
}
template <int number>
inline FloatRow row_of(FloatBand band) {
  constexpr int at = 4 * number;
  return __builtin_shufflevector(band, band, at, at + 1, at + 2, at + 3);
}
#endif

// In each 128 bits, `mixed` alternates the first (or last) numbers of a and b; `halves` joins the first (or last)
// halves of a and b.
inline DoubleRow first_mixed(DoubleRow a, DoubleRow b) { return __builtin_shufflevector(a, b, 0, 4, 2, 6); }
inline DoubleRow last_mixed(DoubleRow a, DoubleRow b) { return __builtin_shufflevector(a, b, 1, 5, 3, 7); }
inline DoubleRow first_halves(DoubleRow a, DoubleRow b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
inline DoubleRow last_halves(DoubleRow a, DoubleRow b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
inline FloatRow first_mixed(FloatRow a, FloatRow b) { return __builtin_shufflevector(a, b, 0, 4, 1, 5); }
inline FloatRow last_mixed(FloatRow a, FloatRow b) { return __builtin_shufflevector(a, b, 2, 6, 3, 7); }
inline FloatRow first_halves(FloatRow a, FloatRow b) { return __builtin_shufflevector(a, b, 0, 1, 4, 5); }
inline FloatRow last_halves(FloatRow a, FloatRow b) { return __builtin_shufflevector(a, b, 2, 3, 6, 7); }
#ifdef __AVX512F__
inline DoubleBand first_mixed(DoubleBand a, DoubleBand b) {
  return __builtin_shufflevector(a, b, 0, 8, 2, 10, 4, 12, 6, 14);
}
inline DoubleBand last_mixed(DoubleBand a, DoubleBand b) {
  return __builtin_shufflevector(a, b, 1, 9, 3, 11, 5, 13, 7, 15);
}
inline DoubleBand first_halves(DoubleBand a, DoubleBand b) {
  return __builtin_shufflevector(a, b, 0, 1, 8, 9, 4, 5, 12, 13);
}
inline DoubleBand last_halves(DoubleBand a, DoubleBand b) {
  return __builtin_shufflevector(a, b, 2, 3, 10, 11, 6, 7, 14, 15);
}
inline FloatBand first_mixed(FloatBand a, FloatBand b) {
  return __builtin_shufflevector(a, b, 0, 16, 1, 17, 4, 20, 5, 21, 8, 24, 9, 25, 12, 28, 13, 29);
}
inline FloatBand last_mixed(FloatBand a, FloatBand b) {
  return __builtin_shufflevector(a, b, 2, 18, 3, 19, 6, 22, 7, 23, 10, 26, 11, 27, 14, 30, 15, 31);
}
inline FloatBand first_halves(FloatBand a, FloatBand b) {
  return __builtin_shufflevector(a, b, 0, 1, 16, 17, 4, 5, 20, 21, 8, 9, 24, 25, 12, 13, 28, 29);
}
inline FloatBand last_halves(FloatBand a, FloatBand b) {
  return __builtin_shufflevector(a, b, 2, 3, 18, 19, 6, 7, 22, 23, 10, 11, 26, 27, 14, 15, 30, 31);
}
#endif

// first_mixed(a, 0). In double it is a blend, with the same bits. Reason: under the thread sanitizer g++ 12 compiles
// the unpacking of a newly loaded register with 0 to a doubling of this register (vmovddup), which is wrong.
inline DoubleRow first_alone(DoubleRow a) { return __builtin_shufflevector(a, DoubleRow{}, 0, 5, 2, 7); }
inline FloatRow first_alone(FloatRow a) { return first_mixed(a, FloatRow{}); }
#ifdef __AVX512F__
inline DoubleBand first_alone(DoubleBand a) {
  return __builtin_shufflevector(a, DoubleBand{}, 0, 9, 2, 11, 4, 13, 6, 15);
}
inline FloatBand first_alone(FloatBand a) { return first_mixed(a, FloatBand{}); }
#endif

template <typename Real>
inline void put_band(Real* numbers, Band<Real> band) {
  *reinterpret_cast<Band<Real>*>(numbers) = band;
}
template <typename Real>
inline Band<Real> band_at(const Real* numbers) {
  return *reinterpret_cast<const Band<Real>*>(numbers);
}

/// Writes x, y and z of four bands as columns.
template <typename Real>
inline void put_columns(const Band<Real> (&b)[4], Real* x, Real* y, Real* z) {
  if constexpr (std::is_same_v<Real, double>) {  // mixing gives x (or y) and z (or w) of two rows
    const Band<Real> xz_01 = first_mixed(b[0], b[1]), xz_23 = first_mixed(b[2], b[3]);
    put_band(x, first_halves(xz_01, xz_23));
    put_band(y, first_halves(last_mixed(b[0], b[1]), last_mixed(b[2], b[3])));
    put_band(z, last_halves(xz_01, xz_23));
  } else {  // mixing gives x and y (or z and w) of two rows
    const Band<Real> xy_01 = first_mixed(b[0], b[1]), xy_23 = first_mixed(b[2], b[3]);
    put_band(x, first_halves(xy_01, xy_23));
    put_band(y, last_halves(xy_01, xy_23));
    put_band(z, first_halves(last_mixed(b[0], b[1]), last_mixed(b[2], b[3])));
  }
}

/// The inverse: four bands of rows (x, y, z, 0) from columns.
template <typename Real>
inline void get_bands(const Real* x, const Real* y, const Real* z, Band<Real> (&b)[4]) {
  const Band<Real> none{}, xs = band_at(x), ys = band_at(y), zs = band_at(z);
  const Band<Real> xy_first = first_mixed(xs, ys), z_first = first_alone(zs);
  const Band<Real> xy_last = last_mixed(xs, ys), z_last = last_mixed(zs, none);
  // Mixing pairs lanes 0 and 2 (1 and 3) of each four in double, 0 and 1 (2 and 3) in float.
  constexpr int second = std::is_same_v<Real, double> ? 1 : 2;
  b[0] = first_halves(xy_first, z_first);
  b[second] = first_halves(xy_last, z_last);
  b[3 - second] = last_halves(xy_first, z_first);
  b[3] = last_halves(xy_last, z_last);
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
