// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/worker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace flowslide::native {
namespace {

/// By how much a grain may stray before the list is built anew, as shares of the smallest diameter. Little leaves few
/// open pairs in the list, much makes it last longer; the worker looks for the balance, and no result depends on it.
constexpr double least_at_rest = 2e-4, most_at_rest = 0.02, most = 0.05;
/// Steps that a list should last: fewer, and grains are allowed more; more, and less.
constexpr std::int64_t shortest_age = 100, longest_age = 400;
/// A fast grain is allowed what it goes in that many steps, so that some rattlers do not burden the lists of all.
constexpr double steps_of_fast_grains = 200.0;

auto rows(std::vector<std::array<double, 2>>& pairs) {
  static_assert(sizeof(std::array<double, 2>) == sizeof(double[2]));
  return reinterpret_cast<double(*)[2]>(pairs.data());
}

}  // namespace

template <typename Real>
Worker<Real>::Worker(const Share& share, Grains<Real>& grains, const Boundaries& boundaries, double first_allowance,
                     const Passes<Real>& passes)
    : share_(share),
      grains_(grains),
      boundaries_(boundaries),
      passes_(passes),
      list_(share),
      loads_(grains.bodies.size()),
      across_(grains.moments.size()),
      start_(grains.bodies.size()),
      allowance_(grains.role.size()),
      allowance_at_rest_(first_allowance) {}

template <typename Real>
std::vector<Body<Real>>& Worker<Real>::seen(int turn) {
  if constexpr (std::is_same_v<Real, double>)
    if (grains_.published[0].empty()) return grains_.bodies;
  return grains_.published[grains_.published[1].empty() ? 0 : static_cast<std::size_t>(turn)];
}

template <typename Real>
MovingGrains<Real> Worker<Real>::moving(const Share& part, int turn) {
  return {part.begin,          part.end,           grains_.kick.data(), grains_.twist.data(),
          grains_.bodies.data(), seen(turn).data(), loads_.data()};
}

template <typename Real>
void Worker<Real>::publish(int turn) {
  std::vector<Body<Real>>& shown = seen(turn);
  if (static_cast<void*>(&shown) == &grains_.bodies) return;
  for (std::size_t i = share_.begin; i < share_.end; ++i) shown[i] = in_precision<Real>(grains_.bodies[i]);
}

template <typename Real>
void Worker<Real>::fold(std::vector<Fold>& folds) {
  // At every step, not when the list is built: a folded coordinate rounds differently.
  const Cell& cell = boundaries_.cell();
  for (std::size_t i = share_.begin; i < share_.end; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      double& x = grains_.bodies[i].position[axis];
      const bool below = x < cell.lower[axis], above = x >= cell.upper[axis];
      if ((!below && !above) || !cell.periodic[axis] || !std::isfinite(x)) continue;  // count_grains sees a lost grain
      const int periods = below ? 1 : -1;
      x += periods * cell.lengths()[axis];
      start_[i].position[axis] += periods * cell.lengths()[axis];
      folds.push_back({static_cast<std::uint32_t>(i), axis, periods});
    }
}

template <typename Real>
void Worker<Real>::begin(bool first, int turn) {
  const bool carried = boundaries_.carries();
  boundaries_.advance();
  const MeanFlow flow = boundaries_.mean_flow();
  drift_.add(flow, grains_.time_step);
  const MotionExtremes extremes = passes_.motion(first ? MotionPart::begin : MotionPart::end_and_begin,
                                                 grains_.time_step, flow, boundaries_.periods(), moving(share_, turn));
  if (carried) boundaries_.carry(grains_.bodies);
  News& news = news_[static_cast<std::size_t>(turn)];
  news.fluctuation_squared = extremes.fluctuation_squared;
  news.folds.clear();
  if (carried || extremes.outside) fold(news.folds);
  if (carried || !news.folds.empty()) publish(turn);
  if (measures_) news.slack = passes_.slack(drift_, start_.data(), moving(share_, turn));
}

template <typename Real>
void Worker<Real>::meet(const std::vector<Worker>& all, int turn) {
  double squared = 0.0, measured = std::numeric_limits<double>::infinity();
  for (const Worker& worker : all) {
    const News& news = worker.news_[static_cast<std::size_t>(turn)];
    squared = std::max(squared, news.fluctuation_squared);
    measured = std::min(measured, news.slack);
    for (const Fold& fold : news.folds) list_.carry(fold.grain, fold.axis, fold.periods);
  }
  // Two neighbours, or a grain and a plane, meet by what both stray and by what the mean flow does over their distance.
  const double reach = longest_reach(grains_);
  const double pace = grains_.time_step * (std::sqrt(squared) + 0.5 * boundaries_.mean_flow_speed(reach) +
                                           boundaries_.side_speed());
  ++list_age_;
  slack_ = measures_ ? measured - 0.5 * reach * drift_.steepness() : slack_ - pace;
  const bool exhausted = measures_ && slack_ < 4.0 * pace;  // measuring at every step costs more than a list
  compressed_ = compressed_ || boundaries_.compresses();
  measures_ = !compressed_ && slack_ < 2.0 * pace;
  if (exhausted || !(slack_ > 0.0)) rebuild(turn);
}

template <typename Real>
void Worker<Real>::allow(const std::vector<Body<Real>>& bodies) {
  const MeanFlow flow = boundaries_.mean_flow();
  for (std::size_t i = 0; i < allowance_.size(); ++i) {
    double squared = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double fluctuation =
          bodies[i].velocity[axis] - (flow.base[axis] + flow.slope[axis] * (bodies[i].position[2] - flow.origin));
      squared += fluctuation * fluctuation;
    }
    allowance_[i] = std::min(allowance_at_rest_ + steps_of_fast_grains * grains_.time_step * std::sqrt(squared),
                             most * grains_.smallest_diameter);
  }
}

template <typename Real>
void Worker<Real>::rebuild(int turn) {
  const double size = grains_.smallest_diameter;
  if (list_age_ > 0) {  // not the first
    if (list_age_ < shortest_age) allowance_at_rest_ = std::min(1.5 * allowance_at_rest_, most_at_rest * size);
    if (list_age_ > longest_age) allowance_at_rest_ = std::max(0.8 * allowance_at_rest_, least_at_rest * size);
  }
  allow(seen(turn));
  list_.build(boundaries_.cell(), seen(turn), grains_.role, allowance_);
  boundaries_.find_near(grains_.bodies, grains_.role, most * size);
  for (std::size_t i = share_.begin; i < share_.end; ++i) {
    const double* x = grains_.bodies[i].position;
    start_[i] = {{x[0], x[1], x[2]}, allowance_[i]};
  }
  slack_ = *std::min_element(allowance_.begin(), allowance_.end());
  list_age_ = 0;
  drift_ = {};
  compressed_ = measures_ = false;
}

template <typename Real>
void Worker<Real>::evaluate(int turn, bool last) {
  if (last) std::fill(across_.begin(), across_.end(), std::array<double, 2>{});
  passes_.contacts(grains_.variant, grains_.law, list_.view(boundaries_.cell()), seen(turn).data(), loads_.data(),
                   last ? rows(across_) : nullptr);
  boundaries_.push(grains_.bodies, grains_.role, loads_);
  if (!last) return;
  measure(turn);
  for (std::size_t block = share_.begin / block_size; block * block_size < share_.end; ++block)
    grains_.across[block] = across_[block];
}

template <typename Real>
void Worker<Real>::measure(int turn) {
  const Cell& cell = boundaries_.cell();
  alignas(32) double origin[4] = {}, weight_of_glued[4] = {};
  Vector3::Map(origin) = cell.lower;
  for (int axis = 0; axis < 3; ++axis) weight_of_glued[axis] = cell.periodic[axis] ? 1.0 : 0.0;
  const Box confines = boundaries_.confines();
  for (std::size_t begin = share_.begin; begin < share_.end; begin += block_size)
    grains_.moments[begin / block_size] = passes_.moments(
        origin, weight_of_glued, confines, moving({begin, std::min(begin + block_size, share_.end)}, turn));
}

template <typename Real>
void Worker<Real>::end(std::vector<Body<double>>& bodies) const {
  passes_.motion(MotionPart::end, grains_.time_step, boundaries_.mean_flow(), boundaries_.periods(),
                 {share_.begin, share_.end, grains_.kick.data(), grains_.twist.data(), bodies.data(), nullptr,
                  const_cast<Load<Real>*>(loads_.data())});
}

template <typename Real>
void Worker<Real>::add_boundary_forces(StressSums& sums) const {
  boundaries_.add_upper_plane(grains_.bodies, sums.upper_plane);
  for (const std::uint32_t i : grains_.top_layer)
    for (int axis = 0; axis < 3 && share_.owns(i); ++axis) sums.top_force[axis] -= loads_[i].force[axis];
  const double drag = boundaries_.settings().drag;
  if (drag == 0.0) return;
  for (std::size_t i = share_.begin; i < share_.end; ++i) {
    if (grains_.role[i] != Role::mobile) continue;
    const Vector3 resistance = -drag * Vector3::Map(grains_.bodies[i].velocity);
    const Vector3 arm = Vector3::Map(grains_.bodies[i].position) - boundaries_.cell().lower;
    sums.mobile_height_times_force -= arm.z() * resistance;
    sums.mobile_moment -= arm.cwiseProduct(resistance);
  }
}

template <typename Real>
void Worker<Real>::add_histories(int turn, std::vector<ContactHistory>& contacts) const {
  list_.add_histories(seen(turn), contacts);
}

template <typename Real>
double Worker<Real>::longest_reach(const Grains<Real>& grains) {
  return grains.largest_diameter + 2.0 * most * grains.smallest_diameter;
}

template class Worker<double>;
template class Worker<float>;

}  // namespace flowslide::native
