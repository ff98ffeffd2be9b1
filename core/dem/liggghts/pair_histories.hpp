// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// Histories of the touching pairs that this rank answers for; over all ranks each pair appears once. Unsorted.
std::vector<ContactHistory> read_histories(LAMMPS_NS::LAMMPS& lammps);

/// Gives every touching pair of the neighbour list the history it has in `contacts` (sorted by first, second), or none.
void write_histories(LAMMPS_NS::LAMMPS& lammps, const std::vector<ContactHistory>& contacts);

}  // namespace flowslide
