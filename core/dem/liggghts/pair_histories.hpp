// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <vector>

#include "grains/assembly.hpp"
#include "grains/laws/contact_laws.hpp"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// Histories of the touching pairs of this rank, unsorted. Over all ranks each pair appears once. `law` is the present
/// one: a rolling part without history leaves `rolling_torque` at zero. Throws std::logic_error if LIGGGHTS keeps
/// another number of values for each pair than the parts of the law declare.
std::vector<ContactHistory> read_histories(LAMMPS_NS::LAMMPS& lammps, ContactLaw law);

/// Gives every touching pair of the neighbour list its history in `contacts`, or zero if it has none there. `contacts`
/// is sorted by (first, second). Throws as read_histories does.
void write_histories(LAMMPS_NS::LAMMPS& lammps, ContactLaw law, const std::vector<ContactHistory>& contacts);

}  // namespace flowslide
