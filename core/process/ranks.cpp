// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/ranks.hpp"

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <exception>

#include "process/exit_code.hpp"
#include "process/mpi_session.hpp"

namespace flowslide {
namespace {

/// Time for which a failed rank waits for the end of the others. Ranks with the same failure end at once.
constexpr std::chrono::seconds longest_wait{10};

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
  const bool failed = value_of_first_rank(failure ? 1 : 0) != 0;
  if (failure) std::rethrow_exception(failure);
  if (failed) throw FirstRankFailed();
}

bool same_on_all_ranks(bool value) { return value_of_first_rank(value ? 1 : 0) != 0; }

int same_exit_code(int code, const std::string& unsaid) {
  const auto say = [&unsaid] {
    if (unsaid.empty()) return;
    std::fprintf(stderr, "flowslide: rank %d: %s\n", mpi_rank(), unsaid.c_str());
    std::fflush(stderr);
  };
  AtEnd mine{ordered(code, mpi_rank()), code, std::nullopt, say};
  if (failed(code)) mine.longest_wait = longest_wait;
  const std::int64_t first = smallest_at_end(mine);
  if (first == mine.value) say();
  return static_cast<int>(first & 0xFF);
}

}  // namespace flowslide
