// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <limits>
#include <span>
#include <string>

namespace flowslide {

/// Origin of a result: all that is needed to make it again, besides its configuration.
struct Provenance {
  std::string code_version;            ///< of this project, such as "0.1.0"
  std::string git_revision;            ///< 40 hexadecimal digits, or "unknown" outside a repository
  std::string git_state;  ///< "clean", "dirty" (uncommitted changes at build time) or "unknown: <reason>"
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
  std::string point;                   ///< name of the run within the case, such as "e0_790"
  std::string figure;                  ///< of the paper, such as "3"
  std::string scale;                   ///< "quick" or "paper"
  std::int64_t seed = 0;
  int replicate = 0;
  /// Name of the table [sample.<name>] and key of the sample: "loosest 3f...". Equal for runs on one sample. Of
  /// a closed-form sample its name alone: "elastic".
  std::string sample;
  /// Predicted processor time, s, if all samples are in the cache. NaN: not recorded.
  double predicted_seconds = std::numeric_limits<double>::quiet_NaN();
  /// Processor time of all ranks, threads and starts of the program, s; includes the preparation of samples that were
  /// not in the cache. NaN: not recorded.
  double processor_seconds = std::numeric_limits<double>::quiet_NaN();
};

/// The provenance known at the start of a run: build, host, command line and time. `arguments` are those of main(). The
/// case fills in the other members.
Provenance start_provenance(std::span<const char* const> arguments);

/// `arguments` joined by blanks, each quoted for a POSIX shell where needed.
std::string shell_line(std::span<const char* const> arguments);

}  // namespace flowslide
