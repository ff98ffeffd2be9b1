// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstring>
#include <utility>

#include "dem/native/isa/tile.hpp"
#include "dem/native/isa/transpose.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {

#ifdef __AVX512F__
/// The eight numbers of a load as one vector.
template <typename Real>
struct WholeLoad {
  using Type = double __attribute__((vector_size(64), may_alias));
};
template <>
struct WholeLoad<float> {
  using Type = float __attribute__((vector_size(32), may_alias));
};
#endif

/// Adds row `number` of a band of forces and of a band of torques to a load.
template <int number, typename Real>
inline void add_rows(Load<Real>& load, Band<Real> force, Band<Real> torque) {
#ifdef __AVX512F__
  // Force and torque are adjacent in memory and are added together.
  using Whole = typename WholeLoad<Real>::Type;
  constexpr int f = 4 * number, t = f + 4 * rows_in_band<Real>;
  *reinterpret_cast<Whole*>(&load) +=
      __builtin_shufflevector(force, torque, f, f + 1, f + 2, f + 3, t, t + 1, t + 2, t + 3);
#else
  add_row(load.force, row_of<number>(force));
  add_row(load.torque, row_of<number>(torque));
#endif
}

/// Adds the forces and torques of a tile to the loads of the grains, pair after pair in the order of the list.
template <typename Real, bool Spins>
inline void scatter(const PairView<Real>& pairs, std::size_t start, const Tile<Real>& t, Load<Real>* loads) {
  constexpr int lanes = lanes_of_bands<Real>;
  const auto bands_at = [](const Real(&columns)[3][tile_size], int k, Band<Real>(&bands)[4]) {
    get_bands(&columns[0][k], &columns[1][k], &columns[2][k], bands);
  };
  for (int k = 0; k < Tile<Real>::size; k += lanes) {
    const std::uint32_t *first = pairs.first + start + k, *second = pairs.second + start + k;
    Band<Real> force[4], first_torque[4], second_torque[4];
    bands_at(t.force, k, force);
    if constexpr (Spins) {
      bands_at(t.torque[0], k, first_torque);
      bands_at(t.torque[1], k, second_torque);
    }
    const auto add = [&]<int lane>(std::integral_constant<int, lane>) {
      Load<Real>&a = loads[first[lane]], &b = loads[second[lane]];
      constexpr int band = lane % 4, number = lane / 4;
      if constexpr (Spins) {
        add_rows<number>(a, force[band], first_torque[band]);
        add_rows<number>(b, -force[band], second_torque[band]);
      } else {
        add_row(a.force, row_of<number>(force[band]));
        add_row(b.force, -row_of<number>(force[band]));
      }
    };
    [&]<int... lane>(std::integer_sequence<int, lane...>) {
      (add(std::integral_constant<int, lane>{}), ...);
    }(std::make_integer_sequence<int, lanes>{});
  }
}

/// Adds the products of shift and force of pairs across a face of the cell to the blocks of their first grains (see
/// AcrossFaces). Such pairs are few: the loop checks eight pairs at once.
template <typename Real>
inline void add_across(const PairView<Real>& pairs, std::size_t start, const Tile<Real>& t, AcrossFaces* across) {
  constexpr std::uint64_t inside = 0x0101010101010101u * image_of(0, 0, 0);
  for (std::size_t eight = 0; eight < Tile<Real>::size; eight += 8) {
    std::uint64_t images;
    std::memcpy(&images, pairs.image + start + eight, 8);
    if (images == inside) continue;
    for (std::size_t k = eight; k < eight + 8; ++k) {
      const std::uint8_t image = pairs.image[start + k];
      if (image == image_of(0, 0, 0)) continue;
      const double* shift = pairs.image_shift[image];
      AcrossFaces& sums = across[pairs.first[start + k] / block_size];
      for (std::size_t axis = 0; axis < 2; ++axis) sums[axis] += shift[axis] * static_cast<double>(t.force[axis][k]);
      if (shift[2] == 0.0) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) sums[axis + 2] += shift[2] * static_cast<double>(t.force[axis][k]);
    }
  }
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
