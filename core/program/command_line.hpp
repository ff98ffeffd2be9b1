// SPDX-License-Identifier: GPL-2.0-or-later
// The command-line options of every case program.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// The description of a case for its help text and its output.
struct CaseDescription {
  std::string name;                  ///< "fig03_undrained"
  std::string description;           ///< one sentence
  std::string version;               ///< version that --version prints after the name
  std::vector<std::string> figures;  ///< "Fig. 3", ...
  std::vector<std::string> engines;  ///< names that --engine accepts
};

/// The options of one start of the program.
struct CommandLine {
  std::optional<std::filesystem::path> configuration_file;  ///< --config
  std::vector<Override> overrides;                          ///< --set, and other options that set a key
  std::string scale = "quick";                              ///< --scale
  std::filesystem::path output;                             ///< --output; without it results/<case>/<scale>
  std::vector<std::string> points;                          ///< --point; empty: all
  bool resume = false;                                      ///< --resume
  bool afresh = false;                                      ///< --afresh
  int threads = 0;                                          ///< --threads; 0: the engine decides
  double checkpoint_interval = 180.0;                       ///< --checkpoint-interval, s
  double max_walltime = std::numeric_limits<double>::infinity();  ///< --max-walltime, s
  bool status = false;                                      ///< --status
  bool so_far = false;                                      ///< --so-far
  bool dry_run = false;                                     ///< --dry-run
  bool list = false;                                        ///< --list
  bool check = false;                                       ///< --check
  bool prepare = false;                                     ///< --prepare
  bool json = false;                                        ///< --json, with --list, --status or --check
};

/// Reads the options. Throws ConfigurationError for an unknown option, for a missing or invalid value, and for options
/// that exclude each other. Throws FinishedEarly for --help and --version.
CommandLine parse(int argc, const char* const* argv, const CaseDescription& description);

/// The layers of the configuration: the case file, its scale, --config, then --set and the options for the keys
/// `engine`, `seed`, `replicates` and `coupling.allow_unstable`.
Layers layers_of(const CommandLine& command_line, const std::filesystem::path& case_file);

/// The points to run, in the order of `available`: those named by --point, or all without this option. Throws
/// ConfigurationError for an unknown name and proposes the nearest one.
std::vector<std::string> selected_points(const CommandLine& command_line, const std::vector<std::string>& available);

}  // namespace flowslide
