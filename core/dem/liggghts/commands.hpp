// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// Atom type in LIGGGHTS of the role of a grain, and the reverse.
constexpr int atom_type(Role role) { return static_cast<int>(role) + 1; }
constexpr Role role_of(int atom_type) { return static_cast<Role>(atom_type - 1); }

/// Distance between the box of LIGGGHTS and the planes of a rigid axis, as a fraction of the length of the cell. Planes
/// may move outwards by this distance.
inline constexpr double box_margin = 0.25;

/// Treatment of the history of a pair that separates.
enum class SeparatedHistory {
  cleared,  ///< cleared at once, as in the contact law
  kept      ///< kept until the next neighbour list, the default of LIGGGHTS: a new contact may continue the old history
};

/// Commands that set up a simulation of `assembly`, before any grain exists.
std::vector<std::string> setup_commands(const Assembly& assembly, const EngineSettings& settings,
                                        SeparatedHistory separated = SeparatedHistory::cleared);

/// Commands that need the grains: which grains obey Newton's law, which pairs are excluded.
std::vector<std::string> grain_commands();

}  // namespace flowslide
