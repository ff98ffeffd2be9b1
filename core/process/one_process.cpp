// SPDX-License-Identifier: GPL-2.0-or-later
// The session of a build without MPI.
#include "process/mpi_session.hpp"

namespace flowslide {

void ensure_mpi() {}
int mpi_rank() { return 0; }
int mpi_ranks() { return 1; }
const void* all_ranks() { return nullptr; }
int value_of_first_rank(int value) { return value; }
void largest_over_ranks(std::span<double>) {}
std::int64_t smallest_at_end(const AtEnd& mine) { return mine.value; }

}  // namespace flowslide
