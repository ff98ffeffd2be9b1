// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace flowslide::native {

CellGrid::CellGrid(const Cell& cell, const std::vector<Body>& bodies, std::size_t grains, double skin)
    : bodies_(bodies), skin_(skin), periodic_(cell.periodic), lower_(cell.lower), length_(cell.lengths()) {
  double largest = 0.0;
  for (std::size_t i = 0; i < grains; ++i) largest = std::max(largest, bodies[i].radius);
  const double width = 2.0 * largest + skin;
  for (int axis = 0; axis < 3; ++axis) {
    count_[axis] = std::max(1, static_cast<int>(length_[axis] / width));
    count_[axis] = std::min(count_[axis], 256);  // a sparse cell needs no more
  }
  start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
  std::vector<std::uint32_t> bin(grains);
  for (std::size_t i = 0; i < grains; ++i) {
    int index = 0;
    for (int axis = 2; axis >= 0; --axis) index = index * count_[axis] + bin_along(axis, bodies[i].position[axis]);
    bin[i] = static_cast<std::uint32_t>(index);
    ++start_[index + 1];
  }
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  member_.resize(grains);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < grains; ++i) member_[next[bin[i]]++] = static_cast<std::uint32_t>(i);
}

int CellGrid::bin_along(int axis, double coordinate) const {
  const int bin = static_cast<int>(std::floor((coordinate - lower_[axis]) / length_[axis] * count_[axis]));
  return std::clamp(bin, 0, count_[axis] - 1);  // grains at rigid planes, and rounding
}

void CellGrid::later_neighbours(std::uint32_t i, std::vector<Neighbour>& found) const {
  found.clear();
  const Body& body = bodies_[i];
  std::array<int, 3> centre;
  for (int axis = 0; axis < 3; ++axis) centre[axis] = bin_along(axis, body.position[axis]);
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const std::array<int, 3> offset{dx, dy, dz};
        std::array<int, 3> bin, image{0, 0, 0};
        bool inside = true;
        for (int axis = 0; axis < 3; ++axis) {
          bin[axis] = centre[axis] + offset[axis];
          if (bin[axis] >= 0 && bin[axis] < count_[axis]) continue;
          inside = inside && periodic_[axis];
          image[axis] = bin[axis] < 0 ? -1 : 1;
          bin[axis] -= image[axis] * count_[axis];
        }
        if (!inside) continue;
        const int b = (bin[2] * count_[1] + bin[1]) * count_[0] + bin[0];
        for (std::uint32_t m = start_[b]; m < start_[b + 1]; ++m) {
          const std::uint32_t j = member_[m];
          if (j <= i) continue;
          const Body& other = bodies_[j];
          const double reach = body.radius + other.radius + skin_;
          double squared = 0.0;
          for (int axis = 0; axis < 3; ++axis) {
            const double d = body.position[axis] - other.position[axis] - image[axis] * length_[axis];
            squared += d * d;
          }
          if (squared < reach * reach) found.push_back({j, image_of(image[0], image[1], image[2])});
        }
      }
  std::sort(found.begin(), found.end(), [](const Neighbour& a, const Neighbour& b) { return a.index < b.index; });
}

}  // namespace flowslide::native
