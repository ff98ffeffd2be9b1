// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// Writes `assembly` of n grains and m contacts into the new group `name` of `parent`. Every array has the attribute
/// units. Shapes:
///   radius (n), position, velocity, spin, force, torque (n, 3), role (n), contact_pair (m, 2),
///   contact_tangential_spring, contact_rolling_torque (m, 3), cell_lower, cell_upper, cell_periodic (3),
///   cell_shear_offset, cell_shear_velocity (1), both only for a cell that is periodic along z.
/// Throws std::invalid_argument if arrays of the assembly differ in length.
void write_assembly(hdf5::Group& parent, const std::string& name, const Assembly& assembly);

/// Reads an assembly back, bit for bit. Throws CorruptFileError if shapes do not match, if a role or an index is out of
/// range, or if the contacts are not sorted.
Assembly read_assembly(const hdf5::Group& parent, const std::string& name);

}  // namespace flowslide
