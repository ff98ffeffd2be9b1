// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "grains/assembly.hpp"
#include "grains/contact_law.hpp"
#include "grains/material.hpp"

namespace flowslide {

/// A sample that several codes step from the same state, and its loading: the top layer moves along x, the bottom layer
/// stands still.
struct PeerSample {
  Assembly assembly;
  Material material;          ///< with the contact law "hertz"
  double time_step = 5e-7;    ///< s
  double top_velocity = 0.0;  ///< m/s
};

/// Gives the grains of both layers the velocity of their layer, and no spin.
PeerSample with_layers_moving(PeerSample sample);

/// The contact whose scale sqrt(R* delta) is the median of all. Some codes take one stiffness or one dashpot
/// coefficient for all contacts where the law of this project depends on the overlap: they get that of this contact.
struct TypicalContact {
  PairConstants pair;
  double scale = 0.0;  ///< sqrt(R* delta), m
  laws::ContactStiffness stiffness;
  double rolling_stiffness = 0.0;  ///< k_r, N m
  double rolling_damping = 0.0;    ///< coefficient of the rolling dashpot, N m s
};

/// Throws std::invalid_argument for a sample without contacts.
TypicalContact typical_contact(const PeerSample& sample);

/// The position, folded into the cell on its periodic axes, m.
Vector3 position_in_cell(const Cell& cell, Vector3 position);

/// The grains as a table. Comment lines begin with '#' and state the cell. One line a grain, in the order of the
/// assembly:
///   role (0 mobile, 1 bottom layer, 2 top layer), radius (m), position (m), velocity (m/s), spin (rad/s)
std::string sample_table(const PeerSample& sample);

}  // namespace flowslide
