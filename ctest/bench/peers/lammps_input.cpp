// SPDX-License-Identifier: GPL-2.0-or-later
#include "peers/lammps_input.hpp"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "dem/liggghts/commands.hpp"

namespace flowslide {
namespace {

std::string granular_style(const PeerSample& sample, const TypicalContact& typical) {
  const Material& m = sample.material;
  const double squared = typical.pair.effective_radius * typical.pair.effective_radius;
  std::string line = fmt::format(
      "pair_style granular\n"
      "pair_coeff * * hertz/material {:.17g} {:.17g} {:.17g} damping tsuji tangential mindlin NULL {:.17g} {:.17g} "
      "rolling sds {:.17g} {:.17g} {:.17g}",
      m.youngs_modulus, tsuji_restitution(typical.pair), m.poisson_ratio,
      typical.stiffness.tangential_damping / typical.stiffness.normal_damping, m.sliding_friction,
      typical.rolling_stiffness / squared, typical.rolling_damping / squared, m.rolling_friction);
  return line + (m.normal_force_limited ? " limit_damping\n" : "\n");
}

std::string hertz_history_style(const PeerSample& sample, const TypicalContact& typical) {
  const HertzHistoryDamping damping = hertz_history_damping(typical);
  return fmt::format("pair_style gran/hertz/history {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} 1{}\npair_coeff * *\n",
                     typical.stiffness.normal / typical.scale, typical.stiffness.tangential / typical.scale,
                     damping.normal, damping.tangential, sample.material.sliding_friction,
                     sample.material.normal_force_limited ? " limit_damping" : "");
}

}  // namespace

std::string lammps_data(const PeerSample& sample) {
  const Assembly& grains = sample.assembly;
  std::string text = fmt::format("A sample of flowslide\n\n{} atoms\n3 atom types\n\n", grains.size());
  const char* axes = "xyz";
  for (int axis = 0; axis < 3; ++axis) {
    const double margin = grains.cell.periodic[axis] ? 0.0 : box_margin * grains.cell.lengths()[axis];
    text += fmt::format("{:.17g} {:.17g} {}lo {}hi\n", grains.cell.lower[axis] - margin,
                        grains.cell.upper[axis] + margin, axes[axis], axes[axis]);
  }
  text += "\nAtoms # sphere\n\n";
  const auto out = std::back_inserter(text);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Vector3 x = position_in_cell(grains.cell, grains.position[i]);
    fmt::format_to(out, "{} {} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, atom_type(grains.role[i]),
                   2.0 * grains.radius[i], sample.material.density, x.x(), x.y(), x.z());
  }
  text += "\nVelocities\n\n";
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const Vector3 &v = grains.velocity[i], &w = grains.spin[i];
    fmt::format_to(out, "{} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g} {:.17g}\n", i + 1, v.x(), v.y(), v.z(), w.x(),
                   w.y(), w.z());
  }
  return text;
}

double tsuji_restitution(const PairConstants& pair) {
  // The dashpot is alpha sqrt(m* k_n) in LAMMPS, and -sqrt(5) beta sqrt(m* k_n) here, because S_n = 3/2 k_n.
  const double wanted = -std::sqrt(5.0) * pair.damping;
  const auto alpha = [](double e) {
    return 1.2728 + e * (-4.2783 + e * (11.087 + e * (-22.348 + e * (27.467 + e * (-18.022 + e * 4.8218)))));
  };
  double low = 0.0, high = 1.0;  // alpha falls from 1.27 to 3e-4
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (alpha(middle) > wanted ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

HertzHistoryDamping hertz_history_damping(const TypicalContact& typical) {
  const double factor = typical.scale * typical.pair.effective_mass;
  return {typical.stiffness.normal_damping / factor, typical.stiffness.tangential_damping / factor};
}

std::string lammps_script(const PeerSample& sample, LammpsLaw law, const PeerSteps& steps, const std::string& data,
                          const std::string& forces) {
  const TypicalContact typical = typical_contact(sample);
  std::string text = fmt::format(
      "units si\natom_style sphere\nboundary p p f\nnewton off\ncomm_modify vel yes\nread_data {}\n"
      "neighbor {:.17g} bin\nneigh_modify delay 0 every 1 check yes\n"
      "neigh_modify exclude type 2 2\nneigh_modify exclude type 3 3\n",
      data, peer_skin_share * 2.0 * sample.assembly.smallest_radius());
  text += law == LammpsLaw::granular ? granular_style(sample, typical) : hertz_history_style(sample, typical);
  text += "group mobile type 1\ngroup top type 3\nfix integrate mobile nve/sphere\n";
  if (sample.top_velocity != 0.0) text += fmt::format("fix shear top move linear {:.17g} 0 0\n", sample.top_velocity);
  text += fmt::format(
      "timestep {:.17g}\nthermo_style custom step\nrun 0\n"
      "write_dump all custom {} id fx fy fz modify sort id format float %.17g\nrun {}\nrun {}\n",
      sample.time_step, forces, steps.before, steps.timed);
  return text;
}

}  // namespace flowslide
