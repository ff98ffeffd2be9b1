// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// Names of the engines of this build.
std::vector<std::string> engine_names();

/// The engine of that name; `log` is the file for what it writes of itself. Throws std::invalid_argument for an unknown
/// name, and says which there are.
std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log);

}  // namespace flowslide
