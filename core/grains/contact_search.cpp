// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/contact_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace flowslide {
namespace {

/// Grains sorted into a grid of boxes, each at least one largest diameter wide.
class Grid {
 public:
  explicit Grid(const Assembly& assembly) : cell_(assembly.cell) {
    const double width = 2.0 * *std::max_element(assembly.radius.begin(), assembly.radius.end());
    for (int axis = 0; axis < 3; ++axis) count_[axis] = boxes_along(axis, width, assembly.size());
    start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
    for (const Vector3& x : assembly.position) ++start_[index(box_of(x)) + 1];
    for (std::size_t box = 1; box < start_.size(); ++box) start_[box] += start_[box - 1];
    grain_.resize(assembly.size());
    std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
    for (std::uint32_t grain = 0; grain < assembly.size(); ++grain)
      grain_[next[index(box_of(assembly.position[grain]))]++] = grain;
  }

  /// Calls visit(other) once for each grain in the box of `position` and in the boxes around it.
  template <class Visit>
  void for_each_near(const Vector3& position, Visit visit) const {
    const Box home = box_of(position);
    Box box;
    for (int dx = -1; dx <= 1; ++dx) {
      if (!shifted(home, 0, dx, box)) continue;
      for (int dy = -1; dy <= 1; ++dy) {
        if (!shifted(home, 1, dy, box)) continue;
        for (int dz = -1; dz <= 1; ++dz) {
          if (!shifted(home, 2, dz, box)) continue;
          const std::size_t at = index(box);
          for (std::uint32_t k = start_[at]; k < start_[at + 1]; ++k) visit(grain_[k]);
        }
      }
    }
  }

 private:
  using Box = std::array<int, 3>;

  int boxes_along(int axis, double width, std::size_t grains) const {
    // In a sheared cell the boxes of the image above are shifted along x.
    if (axis == 0 && cell_.shear_offset != 0.0) return 1;
    // Limits the number of boxes to about eight per grain in a sparse cell.
    const double most = 2.0 * std::cbrt(static_cast<double>(grains)) + 1.0;
    const double fitting = std::min(std::floor(cell_.lengths()[axis] / width), most);
    // With two boxes on a periodic axis the neighbours on both sides would be the same box.
    const double fewest = cell_.periodic[axis] ? 3.0 : 1.0;
    return fitting >= fewest ? static_cast<int>(fitting) : 1;
  }

  Box box_of(const Vector3& position) const {
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
      double fraction = count_[axis] > 1 ? (position[axis] - cell_.lower[axis]) / cell_.lengths()[axis] : 0.0;
      if (cell_.periodic[axis]) fraction -= std::floor(fraction);
      // Grains beyond the end of a rigid axis belong to its last box, so that they stay neighbours of the grains there.
      const double clamped = std::clamp(std::floor(fraction * count_[axis]), 0.0, count_[axis] - 1.0);
      box[axis] = static_cast<int>(clamped);
    }
    return box;
  }

  /// Sets box[axis] to the neighbour of home[axis]. Returns false if there is none, or if another shift gives the same
  /// box.
  bool shifted(const Box& home, int axis, int shift, Box& box) const {
    const int count = count_[axis];
    box[axis] = home[axis] + shift;
    if (count == 1) return shift == 0;
    if (cell_.periodic[axis]) box[axis] = (box[axis] + count) % count;
    return box[axis] >= 0 && box[axis] < count;
  }

  std::size_t index(const Box& box) const {
    return (static_cast<std::size_t>(box[2]) * count_[1] + box[1]) * count_[0] + box[0];
  }

  Cell cell_;
  Box count_{1, 1, 1};
  std::vector<std::uint32_t> start_;  ///< shape (boxes + 1): index in grain_ of the first grain of a box
  std::vector<std::uint32_t> grain_;  ///< shape (n)
};

bool touch(const Assembly& assembly, std::uint32_t first, std::uint32_t second) {
  const Vector3 branch = assembly.cell.nearest_image(assembly.position[first] - assembly.position[second]);
  const double reach = assembly.radius[first] + assembly.radius[second];
  return branch.squaredNorm() < reach * reach;
}

}  // namespace

bool in_one_layer(const Assembly& assembly, std::uint32_t first, std::uint32_t second) {
  return assembly.role[first] != Role::mobile && assembly.role[first] == assembly.role[second];
}

std::vector<TouchingPair> touching_pairs(const Assembly& assembly, SearchScope scope) {
  std::vector<TouchingPair> pairs;
  if (assembly.size() == 0) return pairs;
  const Grid grid(assembly);
  const bool skip_layers = scope == SearchScope::without_pairs_of_one_layer;
  for (std::uint32_t first = 0; first < assembly.size(); ++first) {
    const std::size_t begin = pairs.size();
    grid.for_each_near(assembly.position[first], [&](std::uint32_t second) {
      if (second <= first || !touch(assembly, first, second)) return;
      if (skip_layers && in_one_layer(assembly, first, second)) return;
      pairs.push_back({first, second});
    });
    std::sort(pairs.begin() + static_cast<std::ptrdiff_t>(begin), pairs.end());
  }
  return pairs;
}

}  // namespace flowslide
