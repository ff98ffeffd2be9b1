// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>

namespace flowslide {

/// Runs `action` on the first MPI rank while the others wait; for everything that touches files. What it throws, the
/// first rank throws on, and the others a ConfigurationError, which `run_main` does not print there.
void on_first_rank(const std::function<void()>& action);

/// What the first rank says, on all ranks.
bool same_on_all_ranks(bool value);

}  // namespace flowslide
