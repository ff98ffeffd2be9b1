// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <tuple>

#include "grains/fields.hpp"
#include "grains/laws/contact.hpp"
#include "grains/laws/lane.hpp"
#include "grains/laws/rolling_friction.hpp"

namespace flowslide::laws {

/// Parameters of the part Epsd3 beside mu_r. The paper does not give the stiffness and the damping; they follow the
/// public input decks of its first author.
struct Epsd3Parameters {
  double rolling_stiffness = 2.25;        ///< factor of k_r, >= 1
  double rolling_viscous_damping = 0.13;  ///< eta_r, fraction of critical damping
  bool torsion_resistance = false;        ///< the torque resists the relative spin about the normal, too

  bool operator==(const Epsd3Parameters&) const = default;
  static constexpr auto fields() {
    return std::tuple{
        Field{"rolling_stiffness", &Epsd3Parameters::rolling_stiffness, "1", Bounds::at_least(1.0)},
        Field{"rolling_viscous_damping", &Epsd3Parameters::rolling_viscous_damping, "1", Bounds::not_negative()},
        Field{"torsion_resistance", &Epsd3Parameters::torsion_resistance}};
  }
};
static_assert(lists_every_member<Epsd3Parameters>());

/// Rolling part: an elastic-plastic spring with a dashpot (J. Ai, J.-F. Chen, J. M. Rotter and J. Y. Ooi, Powder
/// Technol. 206 (2011) 269-282, model C; `rolling_friction epsd3` of LIGGGHTS).
/// With w = w_1 - w_2, minus its part along n unless torsion is resisted, and the stiffness k_n of the normal part:
///   M <- M + k_r w dt,  k_r = rolling_stiffness k_n mu_r^2 R*^2
///   |M| > mu_r |F_n| R*:  M <- M mu_r |F_n| R* / |M|, torque M
///   else                  torque M + eta_r 2 sqrt(I_r k_r) w
/// The torque acts on the second grain, its negative on the first. The history is M, N m. It is neither projected nor
/// rotated with the contact.
struct Epsd3 {
  static constexpr const char* liggghts_model = "epsd3";
  static constexpr bool has_history = true;

  using Parameters = List<RollingFriction, Epsd3Parameters>;
  static constexpr std::tuple liggghts_properties{
      LiggghtsProperty{"coefficientRollingFriction", PropertyKind::per_pair, &RollingFriction::rolling_friction},
      LiggghtsProperty{"coefficientRollingViscousDamping", PropertyKind::per_pair,
                       &Epsd3Parameters::rolling_viscous_damping},
      LiggghtsProperty{"rollingStiffness", PropertyKind::scalar, &Epsd3Parameters::rolling_stiffness}};
  static constexpr std::tuple liggghts_switches{
      LiggghtsSwitch{"torsionTorque", &Epsd3Parameters::torsion_resistance}};

  /// k_r, N m.
  static double stiffness(const auto& p, const PairConstants& pair, double normal_stiffness) {
    return p.rolling_stiffness * normal_stiffness * square(p.rolling_friction) * square(pair.effective_radius);
  }
  /// The coefficient of the dashpot, N m s.
  static double damping(const auto& p, const PairConstants& pair, double stiffness) {
    return p.rolling_viscous_damping * (2.0 * std::sqrt(pair.rolling_inertia * stiffness));
  }
  /// The share of the spin along the normal that the spring and the dashpot do not resist.
  static double free_torsion(const auto& p) { return p.torsion_resistance ? 0.0 : 1.0; }

  /// The torque on the second grain (N m) and the new M.
  static PartForce evaluate(const auto& p, const PlainContact& contact, const PartHistory& stored) {
    const Vector3 spin = contact.motion.spin_first - contact.motion.spin_second;
    const Vector3& n = contact.motion.normal;
    const Vector3 rolling_spin = spin - free_torsion(p) * spin.dot(n) * n;
    const double stiff = stiffness(p, contact.pair, contact.stiffness.normal);
    const double cap = p.rolling_friction * std::abs(contact.normal_force) * contact.pair.effective_radius;
    const Vector3 torque =
        contact.advance ? Vector3(stored.value + stiff * contact.time_step * rolling_spin) : stored.value;
    const Capped elastic = apply_cap(torque, cap, !contact.advance, stored.cap);
    const Vector3 history = contact.advance ? elastic.value : stored.value;
    if (elastic.reached) return {elastic.value, history, true};
    return {elastic.value + damping(p, contact.pair, stiff) * rolling_spin, history, false};
  }

  template <typename Real>
  struct Constants {
    Real rolling_friction;   ///< mu_r
    Real rolling_stiffness;  ///< factor mu_r^2; k_r = value k_n R*^2
    Real rolling_damping;    ///< dashpot = value sqrt(I_r) R* sqrt(s)
    Real free_torsion;       ///< see Epsd3::free_torsion
    /// Multiplies the length of the cap by `factor`.
    void scale_cap(Real factor) { rolling_friction *= factor; }
  };
  /// `normal_stiffness` is the constant of the normal part: k_n = normal_stiffness s.
  template <typename Real>
  static Constants<Real> constants(const auto& p, double normal_stiffness) {
    const double stiffness = p.rolling_stiffness * p.rolling_friction * p.rolling_friction;
    return {static_cast<Real>(p.rolling_friction), static_cast<Real>(stiffness),
            static_cast<Real>(2.0 * p.rolling_viscous_damping * std::sqrt(stiffness * normal_stiffness)),
            static_cast<Real>(free_torsion(p))};
  }

  /// The same for a lane. `bound` is |F_n|. Advances M and returns the torque on the second grain.
  template <typename Real>
  FLOWSLIDE_LANE static Components<Real> torque(const Constants<Real>& c, const StiffnessConstants<Real>& stiffness,
                                                const Lane<Real>& contact, Real bound, Components<Real>& history) {
    constexpr Real tiny = smallest_argument<Real>;  // only avoids 0/0
    const Real torsion = dot(contact.relative_spin, contact.normal);
    const Components<Real> spin = add_scaled(contact.relative_spin, -(c.free_torsion * torsion), contact.normal);
    const Real kn = stiffness.normal * contact.scale, radius = contact.effective_radius;
    const Real turn = contact.time_step * (c.rolling_stiffness * kn * (radius * radius));
    const Components<Real> advanced = add_scaled(history, turn, spin);
    const Real squared = dot(advanced, advanced);
    const Real cap = c.rolling_friction * bound * radius;
    const bool holds = squared <= cap * cap;
    const Real ratio = cap * inverse_root(squared > tiny ? squared : tiny);
    const Real damping =
        holds ? c.rolling_damping * contact.root_rolling_inertia * (radius * contact.root_scale) : Real(0);
    history = (holds ? Real(1) : ratio) * advanced;
    return add_scaled(history, damping, spin);
  }

 private:
  static double square(double x) { return x * x; }
};

}  // namespace flowslide::laws
