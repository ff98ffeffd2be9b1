// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <type_traits>

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

/// Four numbers that are read, added and stored together (a vector extension of g++ and clang++ for any processor).
using DoubleRow = double __attribute__((vector_size(32), may_alias));
using FloatRow = float __attribute__((vector_size(16), may_alias));
template <typename Real>
struct RowOf {
  using Type = DoubleRow;
};
template <>
struct RowOf<float> {
  using Type = FloatRow;
};
template <typename Real>
using Row = typename RowOf<Real>::Type;

template <typename Real>
inline Row<Real> row_at(const Real* numbers) {
  return *reinterpret_cast<const Row<Real>*>(numbers);
}
template <typename Real>
inline void put_row(Real* numbers, Row<Real> row) {
  *reinterpret_cast<Row<Real>*>(numbers) = row;
}
template <typename Real>
inline void add_row(Real* numbers, Row<Real> row) {
  put_row(numbers, row_at(numbers) + row);
}

inline DoubleRow row_in_double(const double* numbers) { return row_at(numbers); }
inline DoubleRow row_in_double(const float* numbers) {
  const auto in_double = [numbers](int i) { return static_cast<double>(numbers[i]); };
  return DoubleRow{in_double(0), in_double(1), in_double(2), in_double(3)};
}
template <typename Real>
inline Row<Real> rounded(DoubleRow row) {
  if constexpr (std::is_same_v<Real, double>)
    return row;
  else
    return __builtin_convertvector(row, FloatRow);
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
