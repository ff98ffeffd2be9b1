// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// Number of the periodic image of a grain that lies x, y, z periods away, each -1, 0 or 1.
constexpr std::uint8_t image_of(int x, int y, int z) {
  return static_cast<std::uint8_t>(((x + 1) * 3 + y + 1) * 3 + z + 1);
}

/// A grain near another, and the image of it that is near.
struct Neighbour {
  std::uint32_t index;
  std::uint8_t image;
};

/// Bins of the grains, each as wide as the reach of the largest pair.
class CellGrid {
 public:
  /// `bodies` are folded into the cell; only the first `grains` count.
  CellGrid(const Cell& cell, const std::vector<Body>& bodies, std::size_t grains, double skin);
  /// Grains of larger index than i within touching plus skin, sorted by index.
  void later_neighbours(std::uint32_t i, std::vector<Neighbour>& found) const;

 private:
  int bin_along(int axis, double coordinate) const;

  const std::vector<Body>& bodies_;
  double skin_;
  std::array<bool, 3> periodic_;
  Vector3 lower_, length_;
  std::array<int, 3> count_;
  std::vector<std::uint32_t> start_, member_;  ///< members of bin b: member_[start_[b]] up to start_[b + 1]
};

}  // namespace flowslide::native
