// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>

namespace flowslide {

/// Runs `action` on the first MPI rank while the others wait; for everything that touches files. What it throws, the
/// first rank throws on, and the others FirstRankFailed.
void on_first_rank(const std::function<void()>& action);

/// What the first rank says, on all ranks.
bool same_on_all_ranks(bool value);

/// The exit code of the program, the same on all ranks: that of the first rank that failed, else that of a rank whose
/// claims are not met, else 0. Every rank calls it last. A rank that has failed alone does not wait for ever for others
/// that wait for it: it ends all of them with its code.
int same_exit_code(int code);

}  // namespace flowslide
