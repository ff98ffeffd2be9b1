// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/pair_list.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace flowslide::native {

template <typename Real>
void PairList<Real>::Columns::resize(std::size_t pairs, bool constant_scale) {
  for (auto* column : {&first, &second}) column->resize(pairs);
  image.resize(pairs);
  for (auto* column : {&first_radius, &second_radius}) column->resize(pairs);
  for (auto* column : {&effective_radius, &root_effective_mass, &root_rolling_inertia}) column->resize(pairs);
  root_scale.resize(constant_scale ? pairs : 0);
}

template <typename Real>
void PairList<Real>::Columns::put(std::size_t p, const Candidate& candidate, std::uint8_t image_now) {
  first[p] = candidate.pair.first;
  second[p] = candidate.pair.second;
  image[p] = image_now;
  first_radius[p] = candidate.first_radius;
  second_radius[p] = candidate.second_radius;
  effective_radius[p] = candidate.effective_radius;
  root_effective_mass[p] = candidate.root_effective_mass;
  root_rolling_inertia[p] = candidate.root_rolling_inertia;
  if (!root_scale.empty()) root_scale[p] = candidate.root_scale;
}

template <typename Real>
auto PairList<Real>::candidate(const NearPair& pair, const Bodies& bodies) const -> Candidate {
  const Body<Real>&a = bodies[pair.first], &b = bodies[pair.second];
  const double mass_a = a.mass, mass_b = b.mass;
  // J = m R^2 about the contact; I_r = 7/5 J_1 J_2 / (J_1 + J_2).
  const double first = mass_a * a.radius * a.radius, second = mass_b * b.radius * b.radius;
  const double radius = a.radius * b.radius / (a.radius + b.radius), mass = mass_a * mass_b / (mass_a + mass_b);
  return {pair,
          a.radius,
          b.radius,
          static_cast<Real>(radius),
          static_cast<Real>(std::sqrt(mass)),
          static_cast<Real>(std::sqrt(1.4 * first * second / (first + second))),
          static_cast<Real>(constant_root_scale(law_, radius, mass))};
}

template <typename Real>
void PairList<Real>::search(const Cell& cell, const Bodies& bodies, const std::vector<Role>& role,
                            const std::vector<double>& allowance, ContactLaw law) {
  law_ = law;
  candidates_.clear();
  folded_.assign(role.size(), 0);
  for (const NearPair& pair : CellGrid(cell, bodies, allowance).pairs(range_))
    if (role[pair.first] == Role::mobile || role[pair.first] != role[pair.second])
      candidates_.push_back(candidate(pair, bodies));
  find_foreign();
  const auto nobody = static_cast<std::uint32_t>(role.size());
  nobody_ = candidate({nobody, nobody + 1, image_of(0, 0, 0)}, bodies);
}

template <typename Real>
void PairList<Real>::find_foreign() {
  foreign_.clear();
  for (const Candidate& c : candidates_)
    for (const std::uint32_t i : {c.pair.first, c.pair.second})
      if (!range_.owns(i)) foreign_.push_back(i);
  std::sort(foreign_.begin(), foreign_.end());
  foreign_.erase(std::unique(foreign_.begin(), foreign_.end()), foreign_.end());
}

template <typename Real>
void PairList<Real>::build(const Cell& cell, const Bodies& bodies, const std::vector<double>& allowance) {
  set_shifts(cell);
  std::swap(old_, columns_);
  const std::size_t old_pairs = pairs_;
  const bool constant_scale = has_constant_scale(law_);
  columns_.resize(candidates_.size() + tile_size, constant_scale);
  pairs_ = 0;
  for (const Candidate& c : candidates_) {
    const auto [i, j, found] = c.pair;
    const auto image = static_cast<std::uint8_t>(found + folded_[i] - folded_[j]);
    const double *a = bodies[i].position, *b = bodies[j].position, *shift = shift_[image];
    const double x = a[0] - (b[0] + shift[0]), y = a[1] - (b[1] + shift[1]), z = a[2] - (b[2] + shift[2]);
    const double reach = c.first_radius + allowance[i] + (c.second_radius + allowance[j]);
    columns_.put(pairs_, c, image);  // the next candidate replaces it if the grains are too far apart
    pairs_ += x * x + y * y + z * z < reach * reach;
  }
  std::size_t padded = pairs_;
  while (padded % tile_size != 0) columns_.put(padded++, nobody_, nobody_.pair.image);
  columns_.resize(padded, constant_scale);
  for (auto& column : columns_.history) column.assign(padded, Real(0));
  keep_histories(old_pairs);
}

template <typename Real>
void PairList<Real>::keep_histories(std::size_t old_pairs) {
  std::size_t o = 0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const auto key = std::tie(columns_.first[p], columns_.second[p]);
    while (o < old_pairs && std::tie(old_.first[o], old_.second[o]) < key) ++o;
    if (o == old_pairs) return;
    if (std::tie(old_.first[o], old_.second[o]) != key) continue;
    for (std::size_t h = 0; h < 6; ++h) columns_.history[h][p] = old_.history[h][o];
  }
}

template <typename Real>
void PairList<Real>::carry(std::uint32_t grain, int axis, int periods) {
  const std::array<int, 3> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const int change = periods * (image_of(x[axis], y[axis], z[axis]) - image_of(0, 0, 0));
  folded_[grain] += change;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const int side = (columns_.first[p] == grain) - (columns_.second[p] == grain);
    columns_.image[p] = static_cast<std::uint8_t>(columns_.image[p] + side * change);
  }
}

template <typename Real>
void PairList<Real>::set_histories(const std::vector<ContactHistory>& contacts) {
  std::size_t c = 0;
  for (std::size_t p = 0; p < pairs_; ++p) {
    const auto key = std::tie(columns_.first[p], columns_.second[p]);
    while (c < contacts.size() && std::tie(contacts[c].first, contacts[c].second) < key) ++c;
    const bool known = c < contacts.size() && std::tie(contacts[c].first, contacts[c].second) == key;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      columns_.history[axis][p] =
          static_cast<Real>(known ? contacts[c].tangential_spring[static_cast<int>(axis)] : 0.0);
      columns_.history[axis + 3][p] =
          static_cast<Real>(known ? contacts[c].rolling_torque[static_cast<int>(axis)] : 0.0);
    }
  }
}

template <typename Real>
void PairList<Real>::forget(LawVariant variant) {
  const std::size_t kept = variant == LawVariant::sliding_and_rolling ? 6 : variant == LawVariant::sliding ? 3 : 0;
  for (std::size_t h = kept; h < 6; ++h) std::fill(columns_.history[h].begin(), columns_.history[h].end(), Real(0));
}

template <typename Real>
Vector3 PairList<Real>::separation(std::size_t pair, const Bodies& bodies) const {
  const Body<Real>&a = bodies[columns_.first[pair]], &b = bodies[columns_.second[pair]];
  const double* shift = shift_[columns_.image[pair]];
  return {a.position[0] - (b.position[0] + shift[0]), a.position[1] - (b.position[1] + shift[1]),
          a.position[2] - (b.position[2] + shift[2])};
}

template <typename Real>
Vector3 PairList<Real>::history(std::size_t first_component, std::size_t pair) const {
  const auto& h = columns_.history;
  return {h[first_component][pair], h[first_component + 1][pair], h[first_component + 2][pair]};
}

template <typename Real>
void PairList<Real>::add_histories(const Bodies& bodies, std::vector<ContactHistory>& contacts,
                                   const PairList* eased) const {
  // Rounding in float shortens a history by a fraction below 2e-7, and leaves a capped history within 4e-7 of its cap.
  const auto cap = [](const Vector3& history, const Vector3& in_eased) {
    if (history.isZero(0.0)) return Cap::unknown;
    return in_eased.norm() < (1.0 - 0.3 * easing) * history.norm() ? Cap::reached : Cap::below;
  };
  for (std::size_t p = 0; p < pairs_; ++p) {
    const std::uint32_t i = columns_.first[p], j = columns_.second[p];
    if (!range_.owns(i) || separation(p, bodies).norm() >= bodies[i].radius + bodies[j].radius) continue;
    ContactHistory contact{i, j, history(0, p), history(3, p)};
    if (eased) {
      contact.spring_cap = cap(contact.tangential_spring, eased->history(0, p));
      contact.torque_cap = cap(contact.rolling_torque, eased->history(3, p));
    }
    contacts.push_back(contact);
  }
}

template <typename Real>
void PairList<Real>::set_shifts(const Cell& cell) {
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        Vector3::Map(shift_[image_of(x, y, z)]) =
            Vector3(x, y, z).cwiseProduct(cell.lengths()) + z * cell.shear_offset * Vector3::UnitX();
}

template <typename Real>
PairView<Real> PairList<Real>::view(const Cell& cell) {
  set_shifts(cell);
  PairView<Real> view{0,
                      columns_.first.size(),
                columns_.first.data(),
                columns_.second.data(),
                columns_.image.data(),
                shift_,
                columns_.first_radius.data(),
                columns_.second_radius.data(),
                columns_.effective_radius.data(),
                columns_.root_effective_mass.data(),
                columns_.root_rolling_inertia.data(),
                columns_.root_scale.data(),
                {},
                {},
                static_cast<Real>(cell.shear_velocity)};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    view.spring[axis] = columns_.history[axis].data();
    view.rolling_torque[axis] = columns_.history[axis + 3].data();
  }
  return view;
}

template class PairList<double>;
template class PairList<float>;

}  // namespace flowslide::native
