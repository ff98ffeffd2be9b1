// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "dem/engine.hpp"

namespace flowslide {

/// The project has this engine, but this build does not. The message says how to get it.
struct MissingEngine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Names of all engines. "liggghts" clears the history of a contact when it opens; "liggghts-stock" keeps it until the
/// next neighbour list. "native" computes in double; "native-mixed" has the contact law in float and is faster.
std::vector<std::string> engine_names();

/// Names of the engines of this build. A build with FLOWSLIDE_LIGGGHTS=OFF has the native engines only.
std::vector<std::string> engine_names_of_build();

/// The engine with this name. LIGGGHTS writes its log to the file `log`. `threads` is for the native engines: 0 means
/// one thread below 10 000 grains and otherwise one thread per core. `communicator` is for LIGGGHTS: it points to the
/// MPI_Comm of the ranks that divide the grains, which must live as long as the engine; nullptr: this process alone.
/// Throws std::invalid_argument for an unknown name, and MissingEngine for an engine that this build does not have; the
/// message gives the names that are allowed.
std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log, int threads = 0,
                                    const void* communicator = nullptr);

/// The commands with which the engine sets up a simulation of `assembly`. Empty for an engine without commands. Throws
/// as make_engine.
std::vector<std::string> setup_text(const std::string& name, const Assembly& assembly, const EngineSettings& settings);

}  // namespace flowslide
