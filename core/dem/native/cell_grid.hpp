// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/grain_range.hpp"
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
  /// The pairs whose gap is below the sum of their allowances and of which the range owns at least one grain: first <
  /// second, sorted.
  std::vector<NearPair> pairs(const GrainRange& range) const;

 private:
  struct Sphere {
    double position[3], reach;
  };
  /// Bins that are contiguous along x, in an image of the cell: the periods along x, y and z (-1, 0 or 1) between the
  /// cell and this image.
  struct BinRow {
    std::size_t first, last;
    std::array<int, 3> image;
  };
  /// The pairs of a range: those in which the range owns the first grain, and those in which it owns only the second.
  struct FoundPairs {
    std::size_t begin;  ///< first grain of the range
    std::vector<NearPair> own, earlier = {};
  };
  int bin_along(int axis, double coordinate) const;
  /// Adds the pairs of grain `i`, which the range owns, with later grains of any range and earlier grains of other
  /// ranges.
  void add_pairs(std::uint32_t i, FoundPairs& found) const;
  /// The same with the grains of some bins.
  void add_from_bins(std::uint32_t i, const BinRow& bins, FoundPairs& found) const;
  /// The same beyond a sheared face. `row` is the first bin of a row along x.
  void add_across_the_shear(std::uint32_t i, std::size_t row, std::array<int, 3> image, FoundPairs& found) const;

  std::array<bool, 3> periodic_;
  Vector3 lower_, length_;
  double shear_offset_;
  std::array<int, 3> count_;
  std::vector<Sphere> sphere_;                 ///< of each grain
  std::vector<std::uint32_t> start_, member_;  ///< grains of bin b: member_[start_[b]] to member_[start_[b + 1] - 1]
  std::vector<Sphere> member_sphere_;          ///< of each entry of member_
};

}  // namespace flowslide::native
