// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/time_step_share.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "grains/contact_law.hpp"
#include "grains/contact_search.hpp"
#include "grains/pair_constants.hpp"

namespace flowslide {
namespace {

/// Action of a contact on a small motion in one step: dt^2 stiffness + 2 dt damping.
struct Spring {
  std::uint32_t first = 0, second = 0;
  Vector3 normal;
  double lever_first = 0.0, lever_second = 0.0;  // m
  double along = 0.0, across = 0.0;              // on translation along and across the normal, kg
  double rolling = 0.0;                          // on rotation, kg m^2
  double free_torsion = 0.0;                     // share of the rotation about the normal that is not resisted
};

double step_action(double stiffness, double damping, double time_step) {
  return time_step * (time_step * stiffness + 2.0 * damping);
}

Spring spring_of(const Material& material, const PairConstants& pair, double overlap, double time_step) {
  const laws::ContactStiffness stiffness = contact_stiffness(material, pair, overlap);
  Spring spring;
  visit_law(material.contact_law, [&]<typename Law>(Law) {
    const double rolling = Law::Rolling::stiffness(material, pair, stiffness.normal);
    spring.rolling = step_action(rolling, Law::Rolling::damping(material, pair, rolling), time_step);
    spring.free_torsion = Law::Rolling::free_torsion(material);
  });
  spring.along = step_action(stiffness.loading, stiffness.normal_damping, time_step);
  if (material.sliding_friction > 0.0)
    spring.across = step_action(stiffness.tangential, stiffness.tangential_damping, time_step);
  return spring;
}

/// The contacts as springs. They act on motions of shape (6 n): displacement times sqrt(m) and rotation times sqrt(I_s)
/// of each grain. Glued grains do not move.
class Network {
 public:
  Network(const Assembly& assembly, const Material& material, double time_step)
      : mass_(assembly.size(), 0.0), inertia_(assembly.size(), 0.0) {
    for (std::size_t i = 0; i < assembly.size(); ++i) {
      if (assembly.role[i] != Role::mobile) continue;
      mass_[i] = 1.0 / std::sqrt(sphere_mass(assembly.radius[i], material));
      inertia_[i] = 1.0 / std::sqrt(sphere_inertia(assembly.radius[i], material));
    }
    for (const auto& [i, j] : touching_pairs(assembly)) {
      const Vector3 branch = assembly.cell.nearest_image(assembly.position[i] - assembly.position[j]);
      const double overlap = assembly.radius[i] + assembly.radius[j] - branch.norm();
      Spring spring =
          spring_of(material, pair_constants(material, assembly.radius[i], assembly.radius[j]), overlap, time_step);
      spring.first = i;
      spring.second = j;
      spring.normal = branch.normalized();
      spring.lever_first = assembly.radius[i] - 0.5 * overlap;
      spring.lever_second = assembly.radius[j] - 0.5 * overlap;
      springs_.push_back(spring);
    }
    add_planes(assembly, material, time_step);
  }

  bool empty() const { return springs_.empty() && planes_.empty(); }
  Eigen::Index size() const { return static_cast<Eigen::Index>(6 * mass_.size()); }

  Eigen::VectorXd times(const Eigen::VectorXd& motion) const {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(motion.size());
    for (const Spring& s : springs_) act(s, motion, result);
    for (const Plane& p : planes_) {
      const Eigen::Index at = 6 * p.grain + p.axis;
      result[at] += p.along * mass_[p.grain] * mass_[p.grain] * motion[at];
    }
    return result;
  }

 private:
  struct Plane {
    std::uint32_t grain;
    int axis;
    double along;
  };

  void act(const Spring& s, const Eigen::VectorXd& motion, Eigen::VectorXd& result) const {
    const Eigen::Index i = 6 * s.first, j = 6 * s.second;
    const Vector3 turn_first = inertia_[s.first] * motion.segment<3>(i + 3);
    const Vector3 turn_second = inertia_[s.second] * motion.segment<3>(j + 3);
    const Vector3 apart = mass_[s.first] * motion.segment<3>(i) - mass_[s.second] * motion.segment<3>(j);
    const Vector3 along = apart.dot(s.normal) * s.normal;
    const Vector3 slip = apart - along - (s.lever_first * turn_first + s.lever_second * turn_second).cross(s.normal);
    const Vector3 force = s.along * along + s.across * slip;
    const Vector3 arm = s.normal.cross(s.across * slip);
    const Vector3 turn = turn_first - turn_second;
    const Vector3 rolling = s.rolling * (turn - s.free_torsion * turn.dot(s.normal) * s.normal);
    result.segment<3>(i) += mass_[s.first] * force;
    result.segment<3>(j) -= mass_[s.second] * force;
    result.segment<3>(i + 3) += inertia_[s.first] * (rolling - s.lever_first * arm);
    result.segment<3>(j + 3) -= inertia_[s.second] * (rolling + s.lever_second * arm);
  }

  void add_planes(const Assembly& assembly, const Material& material, double time_step) {
    for (std::uint32_t grain = 0; grain < assembly.size(); ++grain)
      for (int axis = 0; axis < 3; ++axis) {
        if (assembly.role[grain] != Role::mobile || assembly.cell.periodic[axis]) continue;
        const double radius = assembly.radius[grain], at = assembly.position[grain][axis];
        for (const double overlap :
             {radius - (at - assembly.cell.lower[axis]), radius - (assembly.cell.upper[axis] - at)})
          if (overlap > 0.0)
            planes_.push_back(
                {grain, axis, spring_of(material, plane_constants(material, radius), overlap, time_step).along});
      }
  }

  std::vector<double> mass_, inertia_;  ///< 1/sqrt(m), 1/sqrt(I_s); 0 for glued grains
  std::vector<Spring> springs_;
  std::vector<Plane> planes_;
};

Eigen::VectorXd random_motion(Eigen::Index size) {
  std::mt19937_64 random(1);
  Eigen::VectorXd motion(size);
  for (double& x : motion) x = static_cast<double>(random() >> 11) * 0x1.0p-52 - 1.0;
  return motion.normalized();
}

/// Largest eigenvalue by Lanczos iteration. Each Ritz value is a lower bound.
double largest_eigenvalue(const Network& network, int iterations) {
  Eigen::VectorXd before = Eigen::VectorXd::Zero(network.size()), now = random_motion(network.size());
  Eigen::VectorXd diagonal(iterations), beside(iterations);
  int done = 0;
  double beta = 0.0;
  while (done < iterations) {
    Eigen::VectorXd next = network.times(now) - beta * before;
    diagonal[done] = next.dot(now);
    next -= diagonal[done] * now;
    beta = beside[done] = next.norm();
    ++done;
    if (beta <= 1e-12 * diagonal.head(done).cwiseAbs().maxCoeff()) break;  // the Krylov space is complete
    before = now;
    now = next / beta;
  }
  Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
  solver.computeFromTridiagonal(diagonal.head(done), beside.head(done - 1), Eigen::EigenvaluesOnly);
  return solver.eigenvalues().maxCoeff();
}

}  // namespace

double time_step_share(const Assembly& assembly, const Material& material, double time_step, int iterations) {
  const Network network(assembly, material, time_step);
  return network.empty() ? 0.0 : 0.25 * largest_eigenvalue(network, iterations);
}

double time_step_below_edge(double time_step, double share) {
  if (share == 0.0) return std::numeric_limits<double>::infinity();
  return time_step / std::max(share, std::sqrt(share));
}

double time_step_at_edge(double time_step, double share) { return time_step / std::pow(share, 0.6); }

}  // namespace flowslide
