// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/share.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// A pair of grains, and the number of the image of the second grain that is near the first (see image_of).
struct NearPair {
  std::uint32_t first, second;
  std::uint8_t image;
};

/// A grid of bins for the grains. Each bin is at least as wide as the largest distance of a pair.
class CellGrid {
 public:
  /// `bodies` are folded into the cell. `allowance` (m), shape (n), is the range of each grain beyond its surface; only
  /// the first n bodies count.
  template <typename Real>
  CellGrid(const Cell& cell, const std::vector<Body<Real>>& bodies, const std::vector<double>& allowance);
  /// The pairs whose gap is below the sum of their allowances and of which the share owns at least one grain: first <
  /// second, sorted.
  std::vector<NearPair> pairs(const Share& share) const;

 private:
  struct Sphere {
    double position[3], reach;
  };
  int bin_along(int axis, double coordinate) const;
  void add_pairs(std::uint32_t i, const Share& share, std::vector<NearPair>& later,
                 std::vector<NearPair>& earlier) const;
  void add_across_the_shear(std::uint32_t i, std::size_t row, std::array<int, 3> image, const Share& share,
                            std::vector<NearPair>& later, std::vector<NearPair>& earlier) const;
  void add_from_bins(std::uint32_t i, std::size_t first_bin, std::size_t last_bin, const std::array<int, 3>& image,
                     const Share& share, std::vector<NearPair>& later, std::vector<NearPair>& earlier) const;

  std::array<bool, 3> periodic_;
  Vector3 lower_, length_;
  double shear_offset_;
  std::array<int, 3> count_;
  std::vector<Sphere> sphere_;                 ///< of each grain
  std::vector<std::uint32_t> start_, member_;  ///< grains of bin b: member_[start_[b]] to member_[start_[b + 1] - 1]
  std::vector<Sphere> member_sphere_;          ///< of each entry of member_
};

}  // namespace flowslide::native
