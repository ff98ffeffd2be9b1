// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// Histories of the touching pairs of this rank, unsorted. Over all ranks each pair appears once.
std::vector<ContactHistory> read_histories(LAMMPS_NS::LAMMPS& lammps);

/// Gives every touching pair of the neighbour list its history in `contacts`, or zero if it has none there. `contacts`
/// is sorted by (first, second).
void write_histories(LAMMPS_NS::LAMMPS& lammps, const std::vector<ContactHistory>& contacts);

}  // namespace flowslide
