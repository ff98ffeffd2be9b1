// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/cell_grid.hpp"

#include <algorithm>
#include <cmath>

namespace flowslide::native {
namespace {

constexpr auto in_order = [](const NearPair& a, const NearPair& b) {
  return a.first != b.first ? a.first < b.first : a.second < b.second;
};

}  // namespace

template <typename Real>
CellGrid::CellGrid(const Cell& cell, const std::vector<Body<Real>>& bodies, const std::vector<double>& allowance)
    : periodic_(cell.periodic),
      lower_(cell.lower),
      length_(cell.lengths()),
      shear_offset_(cell.shear_offset),
      sphere_(allowance.size()) {
  const std::size_t grains = allowance.size();
  double largest = 0.0;
  for (std::size_t i = 0; i < grains; ++i) {
    const Body<Real>& body = bodies[i];
    sphere_[i] = {{body.position[0], body.position[1], body.position[2]}, body.radius + allowance[i]};
    largest = std::max(largest, sphere_[i].reach);
  }
  const double width = 2.0 * largest;
  for (int axis = 0; axis < 3; ++axis) {
    count_[axis] = std::max(1, static_cast<int>(length_[axis] / width));
    count_[axis] = std::min(count_[axis], 256);  // limits the number of bins of a sparse cell
  }
  start_.assign(static_cast<std::size_t>(count_[0]) * count_[1] * count_[2] + 1, 0);
  std::vector<std::uint32_t> bin(grains);
  for (std::size_t i = 0; i < grains; ++i) {
    int index = 0;
    for (int axis = 2; axis >= 0; --axis) index = index * count_[axis] + bin_along(axis, sphere_[i].position[axis]);
    bin[i] = static_cast<std::uint32_t>(index);
    ++start_[index + 1];
  }
  for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
  member_.resize(grains);
  member_sphere_.resize(grains);
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  for (std::size_t i = 0; i < grains; ++i) {
    const std::uint32_t m = next[bin[i]]++;
    member_[m] = static_cast<std::uint32_t>(i);
    member_sphere_[m] = sphere_[i];
  }
}

int CellGrid::bin_along(int axis, double coordinate) const {
  const int bin = static_cast<int>(std::floor((coordinate - lower_[axis]) / length_[axis] * count_[axis]));
  return std::clamp(bin, 0, count_[axis] - 1);  // grains at rigid planes, and rounding
}

void CellGrid::add_from_bins(std::uint32_t i, const BinRow& bins, FoundPairs& found) const {
  const Sphere& own = sphere_[i];
  const std::array<int, 3>& image = bins.image;
  const double x = own.position[0] - (image[0] * length_[0] + image[2] * shear_offset_);
  const double y = own.position[1] - image[1] * length_[1], z = own.position[2] - image[2] * length_[2];
  for (std::uint32_t m = start_[bins.first]; m < start_[bins.last + 1]; ++m) {
    const Sphere& other = member_sphere_[m];
    const double dx = x - other.position[0], dy = y - other.position[1], dz = z - other.position[2];
    const double reach = own.reach + other.reach;
    if (dx * dx + dy * dy + dz * dz >= reach * reach) continue;
    const std::uint32_t j = member_[m];
    if (j > i) found.own.push_back({i, j, image_of(image[0], image[1], image[2])});
    if (j < found.begin) found.earlier.push_back({j, i, image_of(-image[0], -image[1], -image[2])});
  }
}

/// In a sheared cell the bins beyond a face along z are shifted along x. The row therefore starts at the image of the
/// grain.
void CellGrid::add_across_the_shear(std::uint32_t i, std::size_t row, std::array<int, 3> image,
                                    FoundPairs& found) const {
  const double x = sphere_[i].position[0] - image[2] * shear_offset_;
  const int centre = static_cast<int>(std::floor((x - lower_[0]) / length_[0] * count_[0]));
  for (int bin = centre - 1; bin <= centre + 1; ++bin) {
    image[0] = bin < 0 ? -1 : bin >= count_[0] ? 1 : 0;
    const int inside = bin - image[0] * count_[0];
    if (inside < 0 || inside >= count_[0] || (image[0] != 0 && !periodic_[0])) continue;  // further than half a period
    add_from_bins(i, {row + inside, row + inside, image}, found);
  }
}

void CellGrid::add_pairs(std::uint32_t i, FoundPairs& found) const {
  std::array<int, 3> centre;
  for (int axis = 0; axis < 3; ++axis) centre[axis] = bin_along(axis, sphere_[i].position[axis]);
  const auto wrap = [&](int axis, int& bin, int& image) {
    image = bin < 0 ? -1 : bin >= count_[axis] ? 1 : 0;
    bin -= image * count_[axis];
    return image == 0 || periodic_[axis];
  };
  std::array<int, 3> image;
  for (int dz = -1; dz <= 1; ++dz)
    for (int dy = -1; dy <= 1; ++dy) {
      int by = centre[1] + dy, bz = centre[2] + dz;
      if (!wrap(1, by, image[1]) || !wrap(2, bz, image[2])) continue;
      const std::size_t row = (static_cast<std::size_t>(bz) * count_[1] + by) * count_[0];
      if (image[2] != 0 && shear_offset_ != 0.0) {
        add_across_the_shear(i, row, image, found);
        continue;
      }
      // The bins along x are contiguous, except those beyond a face of the cell.
      const int from = std::max(centre[0] - 1, 0), to = std::min(centre[0] + 1, count_[0] - 1);
      image[0] = 0;
      add_from_bins(i, {row + from, row + to, image}, found);
      for (int bx : {centre[0] - 1, centre[0] + 1}) {
        if (bx >= 0 && bx < count_[0]) continue;
        if (wrap(0, bx, image[0])) add_from_bins(i, {row + bx, row + bx, image}, found);
      }
    }
}

std::vector<NearPair> CellGrid::pairs(const GrainRange& range) const {
  FoundPairs found{range.begin, {}};
  std::vector<NearPair>&own = found.own, &earlier = found.earlier;
  own.reserve(4 * (range.end - range.begin));
  for (std::size_t i = range.begin; i < range.end; ++i) {
    const auto before = static_cast<std::ptrdiff_t>(own.size());
    add_pairs(static_cast<std::uint32_t>(i), found);
    std::sort(own.begin() + before, own.end(), in_order);
  }
  if (earlier.empty()) return own;
  std::sort(earlier.begin(), earlier.end(), in_order);
  earlier.insert(earlier.end(), own.begin(), own.end());
  return earlier;
}

template CellGrid::CellGrid(const Cell&, const std::vector<Body<double>>&, const std::vector<double>&);
template CellGrid::CellGrid(const Cell&, const std::vector<Body<float>>&, const std::vector<double>&);

}  // namespace flowslide::native
