// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// Atom types of LIGGGHTS stand for the roles of the grains.
constexpr int atom_type(Role role) { return static_cast<int>(role) + 1; }
constexpr Role role_of(int atom_type) { return static_cast<Role>(atom_type - 1); }

/// Room that the box of LIGGGHTS leaves beyond the planes of a rigid axis, as a share of the cell's length: planes may
/// move outwards by this much.
inline constexpr double box_margin = 0.25;

/// What becomes of the history of a pair that separates.
enum class SeparatedHistory {
  cleared,  ///< at once, as the contact law says
  kept      ///< until the next build of the neighbour list, as LIGGGHTS does by itself: it may come back to life
};

/// Commands that set up a simulation of the grains of `assembly`, before any grain exists.
std::vector<std::string> setup_commands(const Assembly& assembly, const EngineSettings& settings,
                                        SeparatedHistory separated = SeparatedHistory::cleared);

/// Commands that need the grains: which of them obey Newton's law, which pairs are left out.
std::vector<std::string> grain_commands();

}  // namespace flowslide
