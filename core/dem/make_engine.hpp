// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// Names of the engines of this build. "liggghts" clears the history of a contact when it opens; "liggghts-stock" keeps
/// it until the next neighbour list. "native" computes in double; "native-mixed" has the contact law in float and is
/// faster.
std::vector<std::string> engine_names();

/// The engine with this name. LIGGGHTS writes its log to the file `log`. `threads` is for the native engines: 0 means
/// one thread below 10 000 grains and otherwise one thread per core. LIGGGHTS uses MPI ranks instead. Throws
/// std::invalid_argument for an unknown name; the message gives the known names.
std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log, int threads = 0);

}  // namespace flowslide
