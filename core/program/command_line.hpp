// SPDX-License-Identifier: GPL-2.0-or-later
// The options that every case shares.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// What a case says about itself.
struct CaseDescription {
  std::string name;                  ///< "fig03_undrained"
  std::string description;           ///< one sentence
  std::string version;               ///< what --version prints after the name
  std::vector<std::string> figures;  ///< "Fig. 3", ...
  std::vector<std::string> engines;  ///< names that --engine takes, in this build
};

/// What the user asked for.
struct CommandLine {
  std::optional<std::filesystem::path> configuration_file;  ///< --config
  std::vector<Override> overrides;                          ///< --set, and the options that stand for keys
  std::string scale = "quick";                              ///< --scale
  std::optional<std::string> engine;                        ///< --engine; without it the key `engine` decides
  std::optional<std::int64_t> seed;                         ///< --seed; without it the key `seed` decides
  std::optional<std::int64_t> replicates;                   ///< --replicates; without it the key `replicates` decides
  std::filesystem::path output;                             ///< --output; results/<case>/<scale> when not given
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
  bool json = false;                                        ///< --json, with --list or --check
  std::string text;                                         ///< the whole command, quoted for a shell, for provenance
};

/// Reads the options. Throws ConfigurationError for an unknown option, a missing or bad value or options that exclude
/// each other (with what is allowed), and FinishedEarly for --help and --version.
CommandLine parse(int argc, const char* const* argv, const CaseDescription& description);

/// The layers of a run: the case file, its scale, --config, then --set and the options that stand for the keys
/// `engine`, `seed`, `replicates` and `coupling.allow_unstable`.
Layers layers_of(const CommandLine& command_line, const std::filesystem::path& case_file);

/// The points to run, in the order of `available`: all, or those asked for with --point. Throws ConfigurationError for
/// a point that is not there, with the nearest one that is.
std::vector<std::string> selected_points(const CommandLine& command_line, const std::vector<std::string>& available);

}  // namespace flowslide
