// SPDX-License-Identifier: GPL-2.0-or-later
// The identity of a run. Skipping, checking, resuming, collecting and the status all compare it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "record/result_file.hpp"

namespace flowslide {

/// Inputs of a run besides its configuration.
struct RunInputs {
  std::string engine = {};              ///< name of the engine or of the closed-form sample; empty: none
  std::string preparation_engine = {};  ///< name of the engine that prepares the sample; empty: no grains
  std::vector<InputTable> tables = {};  ///< tables that the run reads from files
};

/// Versions of the sources that compute a run; empty where the run does not use them.
struct RunVersions {
  std::string run = {};          ///< version of slides and element tests, without the engine
  std::string engine = {};       ///< version of the engine or of the closed-form sample
  std::string preparation = {};  ///< version of the preparation of samples
  std::string search = {};       ///< version of the search for a void ratio
};

/// All that determines one run: its case, its name in the case ("point"), the resolved configuration, the contents of
/// its input files, the sources of slides and element tests, those and the precision of its engine, and those of the
/// preparation of its sample. Two runs of one identity have the same series. The metrics that a case adds are not part
/// of it: after a change of their sources, a run in another folder computes them anew.
class RunIdentity {
 public:
  /// Throws std::invalid_argument if an engine has no version, or a version has no engine.
  RunIdentity(const std::string& case_name, const std::string& point, RunInputs inputs, std::string configuration,
              const RunVersions& versions = {});
  /// The identity of the run that made a result, complete or not.
  explicit RunIdentity(const Result& made);
  /// The identity with this text(); without its tables.
  static RunIdentity from_text(const std::string& text);

  /// Lines "name = value".
  std::string text() const { return context_ + configuration_; }
  const std::string& configuration() const { return configuration_; }
  const RunInputs& inputs() const { return inputs_; }

  bool operator==(const RunIdentity& other) const { return text() == other.text(); }
  /// Differences between `there` and this, for a message: "slope.angle = 0.1 there, 0.2 now; ...". Empty if equal.
  std::string difference_from(const RunIdentity& there) const;

  /// Writes the identity and the input tables into a result.
  void stamp(Result& result) const;

 private:
  RunIdentity() = default;

  RunInputs inputs_;
  std::string context_;        ///< all except the configuration; its names contain a blank, which no key does
  std::string configuration_;  ///< resolved configuration
};

/// State of a result file with respect to a run.
enum class Standing {
  absent,
  damaged,  ///< truncated, altered or not of this program
  other,    ///< result of another identity
  complete  ///< result of this identity
};
struct FoundResult {
  Standing standing = Standing::absent;
  std::string problem;  ///< the damage, or the difference of the other identity
};
FoundResult find_result(const std::filesystem::path& file, const RunIdentity& identity);

/// End of messages about files of another run.
inline constexpr const char* begin_anew =
    "choose another folder with --output, give the options that it was made with, or delete it and run again with "
    "--afresh";

}  // namespace flowslide
