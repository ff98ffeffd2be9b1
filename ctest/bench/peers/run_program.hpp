// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace flowslide {

/// Notes the environment of this process for its children. Call it before MPI starts, which changes the environment.
void note_environment();

/// Whether a program is in the PATH.
bool is_installed(const std::string& program);

/// Runs a program in `folder`, with the noted environment and its output in `folder`/`log`. Returns the output. Throws
/// std::runtime_error with its last lines if it fails.
std::string run_program(const std::vector<std::string>& words, const std::filesystem::path& folder,
                        const std::string& log);

/// Writes a text file. Throws std::runtime_error.
void write_text(const std::filesystem::path& file, const std::string& text);

}  // namespace flowslide
