// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/ranks.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <thread>

#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

/// Time for which a failed rank waits for the end of the others. Ranks with the same failure end at once.
constexpr std::chrono::seconds longest_wait{10};
constexpr std::chrono::milliseconds poll_interval{5};

/// A number whose minimum over the ranks selects the common code: failures come first, ordered by rank, then claims
/// that are not met, then success. Its lowest 8 bits are the code.
std::int64_t ordered(int code, int rank) {
  const std::int64_t kind = code == to_int(ExitCode::ok) ? 2 : code == to_int(ExitCode::claim_not_met) ? 1 : 0;
  return (kind << 40) + (std::int64_t{rank} << 8) + code;
}

bool failed(int code) { return code != to_int(ExitCode::ok) && code != to_int(ExitCode::claim_not_met); }

}  // namespace

void on_first_rank(const std::function<void()>& action) {
  if (mpi_ranks() == 1) return action();
  std::exception_ptr failure;
  if (mpi_rank() == 0) {
    try {
      action();
    } catch (...) {
      failure = std::current_exception();
    }
  }
  int failed = failure ? 1 : 0;
  MPI_Bcast(&failed, 1, MPI_INT, 0, MPI_COMM_WORLD);
  if (failure) std::rethrow_exception(failure);
  if (failed != 0) throw FirstRankFailed();
}

bool same_on_all_ranks(bool value) {
  if (mpi_ranks() == 1) return value;
  int number = value ? 1 : 0;
  MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return number != 0;
}

int same_exit_code(int code) {
  const MPI_Comm others = communicator_at_end();
  if (others == MPI_COMM_NULL || mpi_ranks() == 1) return code;
  std::int64_t mine = ordered(code, mpi_rank()), first = mine;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&mine, &first, 1, MPI_INT64_T, MPI_MIN, others, &request);
  const auto begun = std::chrono::steady_clock::now();
  for (int done = 0; !done;) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (done) break;
    if (failed(code) && std::chrono::steady_clock::now() - begun > longest_wait) MPI_Abort(MPI_COMM_WORLD, code);
    std::this_thread::sleep_for(poll_interval);
  }
  return static_cast<int>(first & 0xFF);
}

}  // namespace flowslide
