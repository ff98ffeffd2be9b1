// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/worker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace flowslide::native {
namespace {

/// A search uses wide allowances. Several lists with narrow allowances are built from the pairs of one search: each
/// list then has few open pairs at low cost. Bounds of the allowances, as fractions of the smallest diameter: of a
/// grain at rest in a list, of any grain in a list, and of any grain in a search (`most`).
constexpr double least_at_rest = 2e-4, most_at_rest = 0.01, most_in_list = 0.02, most = 0.05;
/// Ratio of the allowances of a search to those of a list.
constexpr double wider = 12.0;
/// Desired life of a list in steps. If a list lasts for fewer steps, the allowances grow; if it lasts for more, they
/// shrink. No result depends on this.
constexpr std::int64_t shortest_age = 8, longest_age = 32;
/// The allowance of a grain includes its motion in this number of steps, so that a few fast rattlers do not make all
/// lists short-lived.
constexpr double steps_of_fast_grains = 16.0;
/// Number of pairs after which grains with complete loads are moved, while they are in the cache. No result depends on
/// it.
constexpr std::size_t pairs_at_once = 4 * tile_size;
/// Size (bytes) of grains and loads beyond which grains are fetched ahead of use. No result depends on it.
constexpr std::size_t size_in_cache = std::size_t{4} << 20;

}  // namespace

template <typename Real>
Worker<Real>::Worker(const GrainRange& range, Grains<Real>& grains, const Boundaries& boundaries,
                     double first_allowance, const Passes<Real>& passes)
    : range_(range),
      grains_(grains),
      boundaries_(boundaries),
      passes_(passes),
      list_(range),
      loads_(grains.bodies.size()),
      across_(grains.moments.size()),
      allowance_(grains.role.size()),
      search_allowance_(grains.role.size()),
      allowance_at_rest_(first_allowance) {}

template <typename Real>
void Grains<Real>::fill_buffers(std::size_t workers) {
  first_buffer.clear();
  if constexpr (!std::is_same_v<Real, double>)
    for (const Body<double>& body : bodies) first_buffer.push_back(in_precision<Real>(body));
  second_buffer.clear();
  if (workers > 1) second_buffer = state(0);
}

template <typename Real>
MovingGrains<Real> Worker<Real>::moving(const GrainRange& part, int from, int to) {
  return {part.begin,
          part.end,
          grains_.kick.data(),
          grains_.twist.data(),
          grains_.state_in_double(from).data(),
          grains_.state(to).data(),
          loads_.data()};
}

template <typename Real>
void Worker<Real>::fold(std::vector<Body<double>>& bodies, std::vector<Fold>& folds) {
  // At every step, not only when the list is built, because a folded coordinate rounds differently.
  const Cell& cell = boundaries_.cell();
  for (std::size_t i = range_.begin; i < range_.end; ++i)
    for (int axis = 2; axis >= 0; --axis) {  // z first, because in a sheared cell folding along z changes x
      double& x = bodies[i].position[axis];
      const bool below = x < cell.lower[axis], above = x >= cell.upper[axis];
      if ((!below && !above) || !cell.periodic[axis] || !std::isfinite(x)) continue;  // count_grains sees a lost grain
      const int periods = below ? 1 : -1;
      x += periods * cell.lengths()[axis];
      for (DisplacementCheck<Real>* check : {&list_check_, &search_check_})
        check->carry(i, axis, periods * cell.lengths()[axis]);
      if (axis == 2) cross_the_shear(bodies[i], i, periods);
      folds.push_back({static_cast<std::uint32_t>(i), axis, periods});
    }
}

template <typename Real>
void Worker<Real>::cross_the_shear(Body<double>& body, std::size_t grain, int layers) {
  const Cell& cell = boundaries_.cell();
  body.position[0] += layers * cell.shear_offset;
  body.velocity[0] += layers * cell.shear_velocity;
  for (DisplacementCheck<Real>* check : {&list_check_, &search_check_}) check->cross_the_shear(grain, layers, cell);
}

template <typename Real>
void Worker<Real>::begin(bool first, int buffer) {
  const MeanFlow flow = boundaries_.mean_flow();
  const MotionPart part = first ? MotionPart::begin : MotionPart::end_and_begin;
  finish_first_half(
      passes_.motion(part, grains_.time_step, flow, boundaries_.periods(), moving(range_, 1 - buffer, buffer)), flow,
      buffer);
}

template <typename Real>
void Worker<Real>::finish_first_half(const MotionExtremes& extremes, const MeanFlow& flow, int buffer) {
  for (DisplacementCheck<Real>* check : {&list_check_, &search_check_}) check->follow(flow, grains_.time_step);
  boundaries_.advance();
  const bool carried = boundaries_.carries();
  std::vector<Body<double>>& bodies = grains_.state_in_double(buffer);
  if (carried) boundaries_.carry(bodies);
  StepResults& results = results_[static_cast<std::size_t>(buffer)];
  results.fluctuation_squared = extremes.fluctuation_squared;
  results.folds.clear();
  if (carried || extremes.outside) fold(bodies, results.folds);
  if constexpr (!std::is_same_v<Real, double>)
    if (carried || !results.folds.empty())
      for (std::size_t i = range_.begin; i < range_.end; ++i) grains_.state(buffer)[i] = in_precision<Real>(bodies[i]);
  const MovingGrains<Real> here = moving(range_, buffer, buffer);
  if (list_check_.measures()) results.slack = list_check_.measure(passes_.slack, here);
  if (search_check_.measures()) results.search_slack = search_check_.measure(passes_.slack, here);
}

template <typename Real>
void Worker<Real>::update_list(const std::vector<Worker>& all, int buffer) {
  double squared = 0.0, slack = std::numeric_limits<double>::infinity(), search_slack = slack;
  for (const Worker& worker : all) {
    const StepResults& results = worker.results_[static_cast<std::size_t>(buffer)];
    squared = std::max(squared, results.fluctuation_squared);
    slack = std::min(slack, results.slack);
    search_slack = std::min(search_slack, results.search_slack);
    for (const Fold& fold : results.folds) list_.carry(fold.grain, fold.axis, fold.periods);
  }
  // Two neighbours, or a grain and a plane, approach by their deviations from the mean flow and by the mean flow over
  // their distance.
  const double reach = longest_reach(grains_);
  const double largest_growth =
      grains_.time_step * (std::sqrt(squared) + 0.5 * boundaries_.mean_flow_speed(reach) + boundaries_.side_speed());
  const bool compressed = boundaries_.compresses();
  const bool list_is_old = list_check_.advance(largest_growth, slack, reach, compressed);
  if (search_check_.advance(largest_growth, search_slack, reach, compressed) || boundaries_.renumbers())
    rebuild(buffer);
  else if (list_is_old)
    build(buffer);
}

template <typename Real>
void Worker<Real>::set_allowances(const std::vector<Body<Real>>& bodies) {
  const MeanFlow flow = boundaries_.mean_flow();
  for (std::size_t i = 0; i < allowance_.size(); ++i) {
    double squared = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double fluctuation =
          bodies[i].velocity[axis] - (flow.base[axis] + flow.slope[axis] * (bodies[i].position[2] - flow.origin));
      squared += fluctuation * fluctuation;
    }
    allowance_[i] = std::min(allowance_at_rest_ + steps_of_fast_grains * grains_.time_step * std::sqrt(squared),
                             most_in_list * grains_.smallest_diameter);
    search_allowance_[i] = std::min(wider * allowance_[i], most * grains_.smallest_diameter);
  }
}

template <typename Real>
void Worker<Real>::rebuild(int buffer) {
  const std::vector<Body<double>>& bodies = grains_.state_in_double(buffer);
  set_allowances(grains_.state(buffer));
  list_.search(boundaries_.cell(), grains_.state(buffer), grains_.role, search_allowance_, grains_.law.law);
  search_check_.start(range_, bodies, search_allowance_);
  boundaries_.find_near(bodies, grains_.role, most * grains_.smallest_diameter);
  build(buffer);
}

template <typename Real>
void Worker<Real>::build(int buffer) {
  const double size = grains_.smallest_diameter;
  if (list_check_.age() > 0) {  // not for the first list
    if (list_check_.age() < shortest_age) allowance_at_rest_ = std::min(1.5 * allowance_at_rest_, most_at_rest * size);
    if (list_check_.age() > longest_age) allowance_at_rest_ = std::max(0.8 * allowance_at_rest_, least_at_rest * size);
  }
  set_allowances(grains_.state(buffer));
  list_.build(boundaries_.cell(), grains_.state(buffer), allowance_);
  list_check_.start(range_, grains_.state_in_double(buffer), allowance_);
}

template <typename Real>
void Worker<Real>::fetch_foreign(int buffer) const {
  constexpr std::size_t line = 64;
  const Body<Real>* bodies = grains_.state(buffer).data();
  for (const std::uint32_t i : list_.foreign()) {
    const char* body = reinterpret_cast<const char*>(bodies + i);
    for (std::size_t at = 0; at < sizeof(Body<Real>); at += line) __builtin_prefetch(body + at);
  }
}

template <typename Real>
template <typename Then>
void Worker<Real>::sum_loads(int buffer, AcrossFaces* across, Then then) {
  fetch_foreign(buffer);
  PairView<Real> pairs = list_.view(boundaries_.cell());
  const std::size_t all = pairs.end;
  if (loads_.size() * (sizeof(Body<Real>) + sizeof(Load<Real>)) > size_in_cache) pairs.fetch_end = all;
  GrainRange part{range_.begin, range_.begin};
  for (pairs.end = 0; part.end < range_.end;) {
    pairs.begin = pairs.end;
    pairs.end = std::min(all, pairs.begin + pairs_at_once);
    passes_.contacts(grains_.law, pairs, grains_.state(buffer).data(), loads_.data(), across);
    // Pairs are sorted by their first, smaller grain: no later pair has a grain before it.
    part.end = range_.end;
    if (pairs.end < all)
      part.end = std::clamp<std::size_t>(pairs.first[pairs.end] / block_size * block_size, part.begin, range_.end);
    boundaries_.push(part, grains_.state_in_double(buffer), grains_.role, loads_);
    then(part);
    part.begin = part.end;
  }
}

template <typename Real>
void Worker<Real>::evaluate(int buffer) {
  std::fill(across_.begin(), across_.end(), AcrossFaces{});
  sum_loads(buffer, across_.data(), [&](const GrainRange& part) { measure(part, buffer); });
  for (std::size_t block = range_.begin / block_size; block * block_size < range_.end; ++block)
    grains_.across[block] = across_[block];
}

template <typename Real>
void Worker<Real>::evaluate_and_begin(int buffer) {
  const int next_buffer = 1 - buffer;
  const MeanFlow flow = boundaries_.mean_flow();
  const Box periods = boundaries_.periods();
  MotionExtremes extremes;
  sum_loads(buffer, nullptr, [&](const GrainRange& part) {
    extremes.widen(
        passes_.motion(MotionPart::end_and_begin, grains_.time_step, flow, periods, moving(part, buffer, next_buffer)));
  });
  finish_first_half(extremes, flow, next_buffer);
}

template <typename Real>
void Worker<Real>::measure(const GrainRange& part, int buffer) {
  const Cell& cell = boundaries_.cell();
  alignas(32) double origin[4] = {}, weight_of_glued[4] = {};
  Vector3::Map(origin) = cell.lower;
  for (int axis = 0; axis < 3; ++axis) weight_of_glued[axis] = cell.periodic[axis] ? 1.0 : 0.0;
  const Box confines = boundaries_.confines();
  for (std::size_t begin = part.begin; begin < part.end; begin += block_size)
    grains_.moments[begin / block_size] = passes_.moments(
        origin, weight_of_glued, confines, moving({begin, std::min(begin + block_size, part.end)}, buffer, buffer));
}

template <typename Real>
void Worker<Real>::end(std::vector<Body<double>>& bodies) const {
  passes_.motion(MotionPart::end, grains_.time_step, boundaries_.mean_flow(), boundaries_.periods(),
                 {range_.begin, range_.end, grains_.kick.data(), grains_.twist.data(), bodies.data(), nullptr,
                  const_cast<Load<Real>*>(loads_.data())});
}

template <typename Real>
void Worker<Real>::add_boundary_forces(StressSums& sums) const {
  boundaries_.add_upper_plane(grains_.bodies, sums.upper_plane);
  for (const std::uint32_t i : grains_.top_layer)
    for (int axis = 0; axis < 3 && range_.owns(i); ++axis) sums.top_force[axis] -= loads_[i].force[axis];
  boundaries_.remove_drag_moments(grains_.bodies, grains_.role, sums);
}

template <typename Real>
void Worker<Real>::add_histories(const std::vector<Body<Real>>& half_step,
                                 std::vector<ContactHistory>& contacts) const {
  if constexpr (std::is_same_v<Real, double>) {
    list_.add_histories(half_step, contacts);
  } else {
    PairList<Real> eased = list_;
    const auto law = with_scaled_caps(grains_.law, static_cast<Real>(1.0 - PairList<Real>::easing));
    std::vector<Load<Real>> unused(half_step.size());
    passes_.contacts(law, eased.view(boundaries_.cell()), half_step.data(), unused.data(), nullptr);
    list_.add_histories(half_step, contacts, &eased);
  }
}

template <typename Real>
double Worker<Real>::longest_reach(const Grains<Real>& grains) {
  return grains.largest_diameter + 2.0 * most * grains.smallest_diameter;
}

template struct Grains<double>;
template struct Grains<float>;
template class Worker<double>;
template class Worker<float>;

}  // namespace flowslide::native
