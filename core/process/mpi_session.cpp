// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/mpi_session.hpp"

#include <mpi.h>

#include <cstdlib>
#include <thread>

namespace flowslide {
namespace {

constexpr std::chrono::milliseconds poll_interval{5};

class MpiSession {
 public:
  MpiSession() {
    int initialized = 0;
    MPI_Initialized(&initialized);
    if (initialized) return;
    // Without mpirun, MPI_Init starts Open MPI's daemon. The daemon fails if there is no ssh in PATH, although it never
    // starts a process on another machine. "isolated" avoids the search for ssh.
    ::setenv("OMPI_MCA_plm", "isolated", 0);
    MPI_Init(nullptr, nullptr);
    MPI_Comm_dup(MPI_COMM_WORLD, &at_end_);
  }
  ~MpiSession() {
    int finalized = 0;
    MPI_Finalized(&finalized);
    if (at_end_ == MPI_COMM_NULL || finalized) return;
    MPI_Comm_free(&at_end_);
    MPI_Finalize();
  }
  MPI_Comm at_end() const { return at_end_; }

 private:
  MPI_Comm at_end_ = MPI_COMM_NULL;  ///< null unless MPI was started here
};

const MpiSession& session() {
  static const MpiSession the_session;
  return the_session;
}

/// Whether there may be other ranks: a launcher such as mpirun has started this process, or the caller has started MPI.
/// Otherwise MPI is started only when LIGGGHTS needs it, because the start takes a third of a second.
bool may_have_ranks() {
  static const bool launched =
      std::getenv("OMPI_COMM_WORLD_SIZE") || std::getenv("PMI_SIZE") || std::getenv("PMIX_RANK");
  int initialized = 0;
  MPI_Initialized(&initialized);
  return launched || initialized;
}

}  // namespace

void ensure_mpi() { session(); }

int mpi_rank() {
  if (!may_have_ranks()) return 0;
  ensure_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int mpi_ranks() {
  if (!may_have_ranks()) return 1;
  ensure_mpi();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

const void* all_ranks() {
  static const MPI_Comm world = MPI_COMM_WORLD;
  return mpi_ranks() > 1 ? &world : nullptr;
}

int value_of_first_rank(int value) {
  if (mpi_ranks() > 1) MPI_Bcast(&value, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return value;
}

void largest_over_ranks(std::span<double> values) {
  if (mpi_ranks() == 1) return;
  MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
}

std::int64_t smallest_at_end(const AtEnd& mine) {
  if (mpi_ranks() == 1 || session().at_end() == MPI_COMM_NULL) return mine.value;
  std::int64_t smallest = mine.value;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&mine.value, &smallest, 1, MPI_INT64_T, MPI_MIN, session().at_end(), &request);
  const auto begun = std::chrono::steady_clock::now();
  for (int done = 0; !done;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) break;
    if (mine.longest_wait && std::chrono::steady_clock::now() - begun > *mine.longest_wait) {
      mine.before_abort();
      MPI_Abort(MPI_COMM_WORLD, mine.code);
    }
    std::this_thread::sleep_for(poll_interval);
  }
  return smallest;
}

}  // namespace flowslide
