// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "dem/native/cell_grid.hpp"
#include "dem/native/isa/tile.hpp"

namespace flowslide::native {

void PairList::Columns::reserve(std::size_t n) {
  first.reserve(n);
  second.reserve(n);
  image.reserve(n);
}

void PairList::Columns::append(std::uint32_t i, std::uint32_t j, std::uint8_t shift) {
  first.push_back(i);
  second.push_back(j);
  image.push_back(shift);
}

void PairList::build(const Cell& cell, const std::vector<Body>& bodies, const std::vector<Role>& role, double skin) {
  set_shifts(cell);
  Columns old;
  std::swap(old, columns_);
  const std::size_t old_pairs = pairs_;
  columns_.reserve(old.first.size() + tile_size);
  const CellGrid grid(cell, bodies, role.size(), skin);
  std::vector<Neighbour> neighbours;
  for (std::uint32_t i = 0; i < role.size(); ++i) {
    grid.later_neighbours(i, neighbours);
    for (const Neighbour& neighbour : neighbours)
      if (role[i] == Role::mobile || role[i] != role[neighbour.index])
        columns_.append(i, neighbour.index, neighbour.image);
  }
  pairs_ = columns_.first.size();
  const auto nobody = static_cast<std::uint32_t>(role.size());
  while (columns_.first.size() % tile_size != 0) columns_.append(nobody, nobody + 1, image_of(0, 0, 0));
  for (auto& column : columns_.history) column.assign(columns_.first.size(), 0.0);
  keep_histories(old, old_pairs);
  fill_constants(bodies);
}

void PairList::keep_histories(const Columns& old, std::size_t old_pairs) {
  std::size_t o = 0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const auto key = std::tie(columns_.first[p], columns_.second[p]);
    while (o < old_pairs && std::tie(old.first[o], old.second[o]) < key) ++o;
    if (o == old_pairs) return;
    if (std::tie(old.first[o], old.second[o]) != key) continue;
    for (std::size_t h = 0; h < 6; ++h) columns_.history[h][p] = old.history[h][o];
  }
}

void PairList::fill_constants(const std::vector<Body>& bodies) {
  const std::size_t n = columns_.first.size();
  for (auto* column :
       {&first_radius_, &second_radius_, &effective_radius_, &root_effective_mass_, &root_rolling_inertia_})
    column->resize(n);
  for (std::size_t p = 0; p < n; ++p) {
    const Body &a = bodies[columns_.first[p]], &b = bodies[columns_.second[p]];
    // J = m R^2 about the contact; I_r = 7/5 J_1 J_2 / (J_1 + J_2).
    const double first = a.mass * a.radius * a.radius, second = b.mass * b.radius * b.radius;
    first_radius_[p] = a.radius;
    second_radius_[p] = b.radius;
    effective_radius_[p] = a.radius * b.radius / (a.radius + b.radius);
    root_effective_mass_[p] = std::sqrt(a.mass * b.mass / (a.mass + b.mass));
    root_rolling_inertia_[p] = std::sqrt(1.4 * first * second / (first + second));
  }
}

void PairList::carry(std::uint32_t grain, int axis, int periods) {
  const std::array<int, 3> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const int change = periods * (image_of(x[axis], y[axis], z[axis]) - image_of(0, 0, 0));
  for (std::size_t p = 0; p < pairs_; ++p) {
    const int side = (columns_.first[p] == grain) - (columns_.second[p] == grain);
    columns_.image[p] = static_cast<std::uint8_t>(columns_.image[p] + side * change);
  }
}

void PairList::set_histories(const std::vector<ContactHistory>& contacts) {
  std::size_t c = 0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const auto key = std::tie(columns_.first[p], columns_.second[p]);
    while (c < contacts.size() && std::tie(contacts[c].first, contacts[c].second) < key) ++c;
    const bool known = c < contacts.size() && std::tie(contacts[c].first, contacts[c].second) == key;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_.history[axis][p] = known ? contacts[c].tangential_spring[static_cast<int>(axis)] : 0.0;
      columns_.history[axis + 3][p] = known ? contacts[c].rolling_torque[static_cast<int>(axis)] : 0.0;
    }
  }
}

Vector3 PairList::separation(std::size_t pair, const std::vector<Body>& bodies) const {
  const Body &a = bodies[columns_.first[pair]], &b = bodies[columns_.second[pair]];
  const double* shift = shift_[columns_.image[pair]];
  return {a.position[0] - (b.position[0] + shift[0]), a.position[1] - (b.position[1] + shift[1]),
          a.position[2] - (b.position[2] + shift[2])};
}

std::vector<ContactHistory> PairList::histories(const std::vector<Body>& bodies) const {
  std::vector<ContactHistory> contacts;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const std::uint32_t i = columns_.first[p], j = columns_.second[p];
    if (separation(p, bodies).norm() >= bodies[i].radius + bodies[j].radius) continue;
    const auto& h = columns_.history;
    contacts.push_back({i, j, {h[0][p], h[1][p], h[2][p]}, {h[3][p], h[4][p], h[5][p]}});
  }
  return contacts;
}

void PairList::set_shifts(const Cell& cell) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        Vector3::Map(shift_[image_of(x, y, z)]) = Vector3(x, y, z).cwiseProduct(cell.lengths());
}

PairView PairList::view(const Cell& cell) {
  set_shifts(cell);
  PairView view{columns_.first.size(),
                columns_.first.data(),
                columns_.second.data(),
                columns_.image.data(),
                shift_,
                first_radius_.data(),
                second_radius_.data(),
                effective_radius_.data(),
                root_effective_mass_.data(),
                root_rolling_inertia_.data(),
                {},
                {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view.spring[axis] = columns_.history[axis].data();
    view.rolling_torque[axis] = columns_.history[axis + 3].data();
  }
  return view;
}

}  // namespace flowslide::native
