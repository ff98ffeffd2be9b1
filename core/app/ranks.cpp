// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/ranks.hpp"

#include <mpi.h>

#include <exception>

#include "app/error.hpp"
#include "dem/liggghts/instance.hpp"

namespace flowslide {

void on_first_rank(const std::function<void()>& action) {
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
  if (failed) throw ConfigurationError("the first rank failed");
}

bool same_on_all_ranks(bool value) {
  ensure_mpi();
  int number = value ? 1 : 0;
  MPI_Bcast(&number, 1, MPI_INT, 0, MPI_COMM_WORLD);
  return number != 0;
}

}  // namespace flowslide
