// SPDX-License-Identifier: GPL-2.0-or-later
// The main program of every case.
#pragma once
#include <filesystem>

#include "program/case.hpp"

namespace flowslide {

/// The whole program: reads the command line, then lists, plans, runs or checks. `folder` holds case.toml and
/// claims.toml. Returns the exit code (see ExitCode).
int run_case(Case& the_case, int argc, const char* const* argv, const std::filesystem::path& folder);

}  // namespace flowslide
