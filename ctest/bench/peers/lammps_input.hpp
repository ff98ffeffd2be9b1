// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "peers/peer_sample.hpp"

namespace flowslide {

/// Contact laws of LAMMPS that come near to the law "hertz" of this project.
enum class LammpsLaw {
  granular,       ///< pair_style granular: hertz/material, tsuji, mindlin, rolling sds
  hertz_history,  ///< pair_style gran/hertz/history: no rolling
};

/// Steps of one run of another code.
struct PeerSteps {
  int before = 0;  ///< not timed
  int timed = 0;
};

/// The skin of the neighbour lists of other codes as a fraction of the smallest diameter, as in this project's input of
/// LIGGGHTS.
inline constexpr double peer_skin_share = 0.05;

/// The data file of LAMMPS (atom_style sphere). Types are 1 for mobile grains, 2 for the bottom and 3 for the top
/// layer.
std::string lammps_data(const PeerSample& sample);

/// The restitution for which `damping tsuji` of LAMMPS has the normal dashpot of this project: 0.7292 for e = 0.8. The
/// polynomial of LAMMPS gives 0.71 of this dashpot for e = 0.8 itself.
double tsuji_restitution(const PairConstants& pair);

/// gamma_n and gamma_t of gran/hertz/history, 1/(m s). Its dashpots are gamma sqrt(R* delta) m*; they equal those of
/// this project at the typical contact alone.
struct HertzHistoryDamping {
  double normal = 0.0, tangential = 0.0;
};
HertzHistoryDamping hertz_history_damping(const TypicalContact& typical);

/// The script of LAMMPS: reads `data`, evaluates the forces of the initial state without tangential springs, writes
/// them to `forces` (columns id fx fy fz, N), then makes the steps.
std::string lammps_script(const PeerSample& sample, LammpsLaw law, const PeerSteps& steps, const std::string& data,
                          const std::string& forces);

}  // namespace flowslide
