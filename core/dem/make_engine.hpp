// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// Names of the engines of this build: "liggghts", told to clear histories at separation; "liggghts-stock", which keeps
/// them until it builds its neighbour list; "native", in double; "native-mixed", with the contact law in float, and
/// faster.
std::vector<std::string> engine_names();

/// The engine of that name; `log` is the file for what it writes of itself. Throws std::invalid_argument for an unknown
/// name, and says which there are. `threads` are for the native ones: 0 is one below 10 000 grains, else one for each core;
/// LIGGGHTS works in ranks of MPI instead.
std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log, int threads = 0);

}  // namespace flowslide
