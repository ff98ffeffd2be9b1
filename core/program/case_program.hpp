// SPDX-License-Identifier: GPL-2.0-or-later
// The main program of every case.
#pragma once
#include <filesystem>

#include "program/case.hpp"

namespace flowslide {

/// The whole program: reads the command line, then does what it asks for (list, plan, prepare, run, check, status or
/// tables of unfinished runs). `folder` contains case.toml and claims.toml. Returns the exit code (see ExitCode).
int run_case(Case& the_case, int argc, const char* const* argv, const std::filesystem::path& folder);

}  // namespace flowslide
