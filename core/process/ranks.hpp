// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <string>

namespace flowslide {

/// Runs `action` on the first MPI rank while the others wait; used for all access to files. If `action` throws, the
/// first rank rethrows its exception, and the others throw FirstRankFailed.
void on_first_rank(const std::function<void()>& action);

/// Returns the value of the first rank on all ranks.
bool same_on_all_ranks(bool value);

/// The exit code of the program, the same on all ranks: that of the first rank that failed, otherwise that of a rank
/// whose claims are not met, otherwise 0. Every rank calls this function last. If a rank fails alone, the others may
/// wait for it forever: after 10 s it ends all ranks with its code. Prints `unsaid`, the message that run_main has not
/// printed, to stderr if the common code is that of this rank.
int same_exit_code(int code, const std::string& unsaid = {});

}  // namespace flowslide
