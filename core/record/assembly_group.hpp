// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// Writes `assembly` into the new group `name` of `parent`, every array with its units:
///   radius (n), position, velocity, spin, force, torque (n, 3), role (n), contact_pair (m, 2),
///   contact_tangential_spring, contact_rolling_torque (m, 3), cell_lower, cell_upper, cell_periodic (3).
void write_assembly(hdf5::Group& parent, const std::string& name, const Assembly& assembly);

/// Reads it back, bit for bit. Throws CorruptFileError if shapes do not fit together, a role or an index is out of
/// range, or the contacts are not sorted.
Assembly read_assembly(const hdf5::Group& parent, const std::string& name);

}  // namespace flowslide
