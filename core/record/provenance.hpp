// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace flowslide {

/// Where a result comes from: all that is needed to make it again, beside its configuration.
struct Provenance {
  std::string code_version;            ///< of this project, such as "0.1.0"
  std::string git_revision;            ///< 40 hexadecimal digits, or "unknown" outside a repository
  std::string git_state;  ///< "clean", "dirty" (changes not committed at build time) or "unknown: " and why
  std::string compiler;                ///< name and version
  std::string compiler_flags;
  std::string build_type;
  std::string paper_doi;               ///< as given in CITATION.cff; "unknown" without it
  std::string host;
  std::string command_line;            ///< quoted for a POSIX shell
  std::string start_time;              ///< ISO 8601, UTC, such as "2025-01-31T12:00:00Z"
  std::string engine;                  ///< such as "liggghts"
  std::string engine_version;
  int mpi_ranks = 1;
  std::string case_name;               ///< such as "fig03_undrained"
  std::string point;                   ///< of the case's sweep, such as "e0=0.790"
  std::string figure;                  ///< of the paper, such as "3"
  std::string scale;                   ///< "quick" or "paper"
  std::int64_t seed = 0;
  int replicate = 0;
  /// Table [sample.<name>] and key of the sample in the cache, "loosest 3f...": equal for runs on one sample. Without a
  /// key if the sample is not made of grains.
  std::string sample;
  /// Cost, s: as predicted, with samples in the cache, and what all ranks and threads took, with samples that were not
  /// there, over all starts of the program. Not a number where it was not recorded.
  double predicted_seconds = std::numeric_limits<double>::quiet_NaN();
  double processor_seconds = std::numeric_limits<double>::quiet_NaN();
};

/// What is known at the start of any run: the build, host, command line and time. `arguments` as main() received them.
/// The rest is for the case to fill in.
Provenance start_provenance(std::span<const char* const> arguments);

/// `arguments` joined by blanks, each quoted for a POSIX shell where needed.
std::string shell_line(std::span<const char* const> arguments);

}  // namespace flowslide
