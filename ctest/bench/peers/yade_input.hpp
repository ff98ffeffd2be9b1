// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "peers/lammps_input.hpp"
#include "peers/peer_sample.hpp"

namespace flowslide {

/// The script of YADE (Hertz-Mindlin with bending moments): reads `table` (see sample_table), evaluates the forces of
/// the initial state without tangential springs, writes them to `forces` (columns id fx fy fz, N), makes the steps, and
/// prints a line "flowslide: <steps> steps in <seconds> s".
std::string yade_script(const PeerSample& sample, const PeerSteps& steps, const std::string& table,
                        const std::string& forces);

}  // namespace flowslide
