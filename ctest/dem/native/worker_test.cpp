// SPDX-License-Identifier: GPL-2.0-or-later
// Workers one after the other in one thread, as if each were the fastest: barriers are where loops end.
#include "dem/native/worker.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "pair_search.hpp"
#include "random_pairs.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide::native {
namespace {

/// A lattice and its workers.
template <typename Real>
class Team {
 public:
  /// Shares end at each of `cuts`, multiples of the block size; `reversed`: the last worker is the first to work.
  explicit Team(const std::vector<std::size_t>& cuts, bool reversed = false, double drag = 0.0)
      : assembly_(touching_lattice()), reversed_(reversed) {
    const std::size_t n = assembly_.size();
    grains_.role = assembly_.role;
    grains_.bodies = bodies_of(assembly_);
    grains_.fill_buffers(cuts.size() + 1);
    for (std::size_t i = 0; i < n; ++i) {
      const bool moves = grains_.role[i] == Role::mobile;
      grains_.kick.push_back(moves ? 0.5 * pass_step / grains_.bodies[i].mass : 0.0);
      grains_.twist.push_back(moves ? 0.5 * pass_step / grains_.bodies[i].inertia : 0.0);
    }
    grains_.time_step = pass_step;
    grains_.moments.resize((n + block_size - 1) / block_size);
    grains_.across.resize(grains_.moments.size());
    for (std::uint32_t i = 0; i < n; ++i)
      if (grains_.role[i] == Role::top_layer) grains_.top_layer.push_back(i);
    grains_.law = law_constants<Real>(Material{}, pass_step);
    grains_.smallest_diameter = 2.0 * assembly_.smallest_radius();
    grains_.largest_diameter = 2.0 * *std::max_element(assembly_.radius.begin(), assembly_.radius.end());
    std::size_t begin = 0;
    const auto add_worker = [&](std::size_t end) {
      const GrainRange range{begin, end};
      workers_.emplace_back(range, grains_, Boundaries(assembly_.cell, {Material{}, pass_step, drag}, range), 1e-5,
                            passes<Real>(instruction_sets().back()));
      begin = end;
    };
    for (const std::size_t cut : cuts) add_worker(cut);
    add_worker(n);
    for (Worker<Real>& worker : workers_) worker.rebuild(0);
  }

  void move(const BoundaryMotion& motion) {
    for (Worker<Real>& worker : workers_) worker.boundaries().move(motion);
    for (std::size_t i = 0; i < assembly_.size(); ++i)
      if (grains_.role[i] != Role::mobile)
        Vector3::Map(grains_.bodies[i].velocity) =
            grains_.role[i] == Role::top_layer ? motion.top_velocity : motion.bottom_velocity;
  }
  void run(int steps) {
    int buffer = 1;
    each([&](Worker<Real>& worker) { worker.begin(true, buffer); });
    for (int left = steps; left > 1; --left, buffer = 1 - buffer)
      each([&](Worker<Real>& worker) {
        worker.update_list(workers_, buffer);
        worker.evaluate_and_begin(buffer);
      });
    each([&](Worker<Real>& worker) {
      worker.update_list(workers_, buffer);
      worker.evaluate(buffer);
    });
    grains_.end_run(buffer);
  }
  /// At the end of the step.
  std::vector<Body<double>> bodies() const {
    std::vector<Body<double>> bodies = grains_.bodies;
    for (const Worker<Real>& worker : workers_) worker.end(bodies);
    return bodies;
  }
  StressSums boundary_forces() const {
    StressSums sums;
    for (const Worker<Real>& worker : workers_) worker.add_boundary_forces(sums);
    return sums;
  }
  std::vector<ContactHistory> histories() const {
    std::vector<Body<Real>> half_step;
    for (const Body<double>& body : grains_.bodies) half_step.push_back(in_precision<Real>(body));
    std::vector<ContactHistory> contacts;
    for (const Worker<Real>& worker : workers_) worker.add_histories(half_step, contacts);
    return contacts;
  }
  const Load<Real>& load_of(std::size_t grain) const {
    for (const Worker<Real>& worker : workers_)
      if (worker.range().owns(grain)) return worker.loads()[grain];
    throw std::out_of_range("no worker owns this grain");
  }

  std::vector<Worker<Real>>& workers() { return workers_; }
  const Grains<Real>& grains() const { return grains_; }
  const Assembly& start() const { return assembly_; }

 private:
  template <typename Task>
  void each(Task task) {
    if (reversed_)
      for (auto worker = workers_.rbegin(); worker != workers_.rend(); ++worker) task(*worker);
    else
      for (Worker<Real>& worker : workers_) task(worker);
  }

  Assembly assembly_;
  bool reversed_;
  Grains<Real> grains_;
  std::vector<Worker<Real>> workers_;
};

template <typename Real>
class WorkerOf : public testing::Test {};
using Precisions = testing::Types<double, float>;
TYPED_TEST_SUITE(WorkerOf, Precisions);

const std::vector<std::vector<std::size_t>> partitions = {{64}, {192}, {64, 128}, {64, 128, 192}, {64, 64, 192}};
const BoundaryMotion quick{Vector3::Zero(), {4.0, 1.0, -0.05}, 0.2, -0.1};

template <typename Real>
void expect_same(const Team<Real>& a, const Team<Real>& b) {
  const auto bodies_a = a.bodies(), bodies_b = b.bodies();
  for (std::size_t i = 0; i < a.start().size(); ++i) {
    EXPECT_EQ(vector_of(bodies_a[i].position), vector_of(bodies_b[i].position)) << i;
    EXPECT_EQ(vector_of(bodies_a[i].velocity), vector_of(bodies_b[i].velocity)) << i;
    EXPECT_EQ(vector_of(bodies_a[i].spin), vector_of(bodies_b[i].spin)) << i;
    EXPECT_EQ(vector_of(a.load_of(i).force), vector_of(b.load_of(i).force)) << i;
    EXPECT_EQ(vector_of(a.load_of(i).torque), vector_of(b.load_of(i).torque)) << i;
  }
  for (std::size_t k = 0; k < a.grains().moments.size(); ++k) {
    EXPECT_EQ(vector_of(a.grains().moments[k].moment), vector_of(b.grains().moments[k].moment));
    EXPECT_EQ(a.grains().across[k], b.grains().across[k]);
    EXPECT_EQ(a.grains().moments[k].inside, b.grains().moments[k].inside);
  }
  const auto of_a = a.histories(), of_b = b.histories();
  ASSERT_EQ(of_a.size(), of_b.size());
  for (std::size_t c = 0; c < of_a.size(); ++c) {
    EXPECT_EQ(of_a[c].first, of_b[c].first);
    EXPECT_EQ(of_a[c].tangential_spring, of_b[c].tangential_spring);
    EXPECT_EQ(of_a[c].rolling_torque, of_b[c].rolling_torque);
  }
}

TYPED_TEST(WorkerOf, AnyPartitionAndAnyOrderOfWorkGiveTheSameBits) {
  Team<TypeParam> alone({});
  alone.move(quick);
  alone.run(600);
  ASSERT_GT(alone.histories().size(), 300u);
  for (const auto& cuts : partitions)
    for (const bool reversed : {false, true}) {
      Team<TypeParam> team(cuts, reversed);
      team.move(quick);
      team.run(600);
      expect_same(alone, team);
      ASSERT_FALSE(this->HasFailure()) << cuts.size() << " cuts, reversed " << reversed;
    }
}

TYPED_TEST(WorkerOf, EachHoldsThePairsOfItsGrains) {
  Team<TypeParam> team({64, 192}), alone({});
  const std::size_t all = alone.workers()[0].list().pairs();
  std::size_t sum = 0;
  for (Worker<TypeParam>& worker : team.workers()) {
    const PairView<TypeParam> view = worker.list().view(team.start().cell);
    for (std::size_t p = 0; p < worker.list().pairs(); ++p)
      EXPECT_TRUE(worker.range().owns(view.first[p]) || worker.range().owns(view.second[p]));
    sum += worker.list().pairs();
  }
  EXPECT_GT(sum, all);  // pairs of two ranges are in both lists
  EXPECT_LT(sum, 2 * all);
}

TYPED_TEST(WorkerOf, BoundaryForcesLeaveDragOut) {
  constexpr double drag = 0.5;
  Team<TypeParam> with({64, 128}, false, drag), without({64, 128}, false);
  for (Team<TypeParam>* team : {&with, &without}) team->run(1);
  const StressSums a = with.boundary_forces(), b = without.boundary_forces();
  Vector3 height = Vector3::Zero(), moment = Vector3::Zero();
  double size = 0.0;
  for (std::size_t i = 0; i < with.start().size(); ++i) {
    if (with.grains().role[i] != Role::mobile) continue;
    const Vector3 force = -drag * with.start().velocity[i];  // the first half kick had no load
    const Vector3 arm = vector_of(with.grains().bodies[i].position);
    height += arm.z() * force;
    moment += arm.cwiseProduct(force);
    size += arm.norm() * force.norm();
  }
  EXPECT_EQ(a.top_force, b.top_force);
  // Rounded sums of 180 terms.
  EXPECT_LT((a.mobile_height_times_force - b.mobile_height_times_force + height).norm(), 1e-12 * size);
  EXPECT_LT((a.mobile_moment - b.mobile_moment + moment).norm(), 1e-12 * size);
  EXPECT_GT(size, 0.0);
}

TYPED_TEST(WorkerOf, MeasuresWhatItHolds) {
  Team<TypeParam> team({128});
  team.run(1);
  std::size_t inside = 0;
  Vector3 moment = Vector3::Zero(), expected = Vector3::Zero();
  double size = 0.0;
  for (const Moments& block : team.grains().moments) {
    inside += block.inside;
    moment += vector_of(block.moment);
  }
  for (std::size_t i = 0; i < team.start().size(); ++i) {
    Vector3 part = vector_of(team.grains().bodies[i].position).cwiseProduct(vector_of(team.load_of(i).force));
    if (team.grains().role[i] != Role::mobile) part.z() = 0.0;  // x and y are periodic
    expected += part;
    size += part.norm();
  }
  EXPECT_EQ(inside, team.start().size());
  EXPECT_LT((moment - expected).norm(), 1e-15 * size);  // 180 rounded terms in double, adding up at random
}

TEST(Worker, ReachesAsFarAsTwoOfTheLargestAndTheirAllowances) {
  Team<double> team({});
  const double reach = Worker<double>::longest_reach(team.grains());
  EXPECT_GT(reach, 1.05 * team.grains().largest_diameter);
  EXPECT_LT(reach, 1.2 * team.grains().largest_diameter);
}

}  // namespace
}  // namespace flowslide::native
