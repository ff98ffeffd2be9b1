// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <tuple>

#include "grains/fields.hpp"
#include "grains/laws/contact.hpp"
#include "grains/laws/lane.hpp"

namespace flowslide::laws {

/// Parameter of the part Sliding.
struct SlidingParameters {
  double sliding_friction = 0.5;  ///< mu

  bool operator==(const SlidingParameters&) const = default;
  static constexpr auto fields() {
    return std::tuple{Field{"sliding_friction", &SlidingParameters::sliding_friction, "1", Bounds::not_negative()}};
  }
};
static_assert(lists_every_member<SlidingParameters>());

/// Tangential part: a spring with history and a dashpot, and Coulomb's cap (P. A. Cundall and O. D. L. Strack,
/// Geotechnique 29 (1979) 47-65; `tangential history` of LIGGGHTS). The normal part gives k_t and gamma_t.
/// With v_t = v - (v.n) n - (c_1 w_1 + c_2 w_2) x n and the lever arms c_i = R_i - delta/2:
///   s <- s + v_t dt, then s <- s - (s.n) n
///   k_t |s| > mu |F_n|:  s <- s mu |F_n| / (k_t |s|), F_t = -k_t s
///   else                 F_t = -k_t s - gamma_t v_t
/// The history is s, m, of the first grain relative to the second.
struct Sliding {
  static constexpr const char* liggghts_model = "history";

  using Parameters = List<SlidingParameters>;
  static constexpr std::tuple liggghts_properties{
      LiggghtsProperty{"coefficientFriction", PropertyKind::per_pair, &SlidingParameters::sliding_friction}};

  /// F_t (N) and the new spring. `velocity` is v_t, m/s.
  static PartForce evaluate(const SlidingParameters& p, const PlainContact& contact, const Vector3& velocity,
                            const PartHistory& stored) {
    const Vector3& n = contact.motion.normal;
    Vector3 spring = stored.value;
    if (contact.advance) {
      spring += velocity * contact.time_step;
      spring -= spring.dot(n) * n;
    }
    const double stiffness = contact.stiffness.tangential;
    const double cap = p.sliding_friction * std::abs(contact.normal_force);
    const Capped elastic = apply_cap(-stiffness * spring, cap, !contact.advance, stored.cap);
    const bool shortened = contact.advance && elastic.reached;
    const Vector3 history = shortened ? Vector3(-elastic.value / stiffness) : spring;
    if (elastic.reached) return {elastic.value, history, true};
    return {elastic.value - contact.stiffness.tangential_damping * velocity, history, false};
  }

  template <typename Real>
  struct Constants {
    Real sliding_friction;
    /// Multiplies the length of the cap by `factor`.
    void scale_cap(Real factor) { sliding_friction *= factor; }
  };
  template <typename Real>
  static Constants<Real> constants(const SlidingParameters& p) {
    return {static_cast<Real>(p.sliding_friction)};
  }

  /// The same for a lane. `bound` is |F_n|. Advances the spring and returns F_t.
  template <typename Real>
  FLOWSLIDE_LANE static Components<Real> force(const Constants<Real>& c, const StiffnessConstants<Real>& stiffness,
                                               const Lane<Real>& contact, Real bound, Components<Real>& spring) {
    constexpr Real tiny = smallest_argument<Real>;  // only avoids 0/0
    const Components<Real>& n = contact.normal;
    const Components<Real> velocity = add_scaled(contact.velocity, -contact.separation_velocity, n) -
                                      cross(contact.surface_spin, n);
    const Components<Real> advanced = across(add_scaled(spring, contact.time_step, velocity), n);
    const Real kt = stiffness.tangential * contact.scale;
    const Real elastic = std::fma(kt, std::sqrt(dot(advanced, advanced)), tiny);
    const Real cap = c.sliding_friction * bound;
    const bool sticks = elastic <= cap;
    const Real ratio = cap / elastic;
    const Real dashpot = contact.root_scale * contact.root_effective_mass;
    const Real damping = sticks ? stiffness.tangential_damping * dashpot : Real(0);
    spring = (sticks ? Real(1) : ratio) * advanced;
    return difference(-kt, spring, damping, velocity);
  }
};

}  // namespace flowslide::laws
