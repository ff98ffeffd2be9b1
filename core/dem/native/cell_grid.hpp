// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/share.hpp"
#include "grains/assembly.hpp"

namespace flowslide::native {

/// A pair of grains, and the image of the second that is near the first.
struct NearPair {
  std::uint32_t first, second;
  std::uint8_t image;
};

/// Bins of the grains, each as wide as the reach of the largest pair.
class CellGrid {
 public:
  /// `bodies` are folded into the cell; as many count as there are allowances, m, by which each reaches beyond its
  /// surface.
  template <typename Real>
  CellGrid(const Cell& cell, const std::vector<Body<Real>>& bodies, const std::vector<double>& allowance);
  /// Pairs nearer than touching plus the allowances of both, first < second, that the share owns at least one of,
  /// sorted.
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
  std::vector<Sphere> sphere_;                 ///< by grain
  std::vector<std::uint32_t> start_, member_;  ///< members of bin b: member_[start_[b]] up to start_[b + 1]
  std::vector<Sphere> member_sphere_;          ///< by member
};

}  // namespace flowslide::native
