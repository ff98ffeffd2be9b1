// SPDX-License-Identifier: GPL-2.0-or-later
// The one answer to "is this the same run?": for skipping a point, checking, resuming, collecting and its status.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "record/result_file.hpp"

namespace flowslide {

/// What decides a run besides its configuration.
struct RunInputs {
  std::string engine = {};              ///< its name, or that of a closed-form sample; empty: none
  std::string preparation_engine = {};  ///< the name of the engine that prepares its sample; empty: no grains
  std::vector<InputTable> tables = {};  ///< that the run reads from files
};

/// Versions of the sources that a run is computed by; empty where the run has none.
struct RunVersions {
  std::string engine = {};       ///< of the engine or the closed-form sample
  std::string preparation = {};  ///< of what makes a sample from its recipe
  std::string search = {};       ///< of the search for a void ratio
};

/// All that went into one run: its case, its point, the resolved configuration, the contents of its input files, the
/// sources and the precision of its engine, and of what prepared its sample. Two runs of one identity have the same
/// result.
class RunIdentity {
 public:
  /// Throws std::invalid_argument if the inputs name an engine whose version is not given.
  RunIdentity(const std::string& case_name, const std::string& point, RunInputs inputs, std::string configuration,
              const RunVersions& versions = {});
  /// That of the run which made a result, complete or not.
  explicit RunIdentity(const Result& made);
  /// The one whose text() this is; its tables are left out.
  static RunIdentity from_text(const std::string& text);

  /// Lines "name = value".
  std::string text() const { return beyond_ + configuration_; }
  const std::string& configuration() const { return configuration_; }
  const RunInputs& inputs() const { return inputs_; }

  bool operator==(const RunIdentity& other) const { return text() == other.text(); }
  /// How `there` differs from this, for a message: "slope.angle = 0.1 there, 0.2 now; ...". Empty if it does not.
  std::string difference_from(const RunIdentity& there) const;

  /// Writes the identity and the input tables into a result.
  void stamp(Result& result) const;

 private:
  RunIdentity() = default;

  RunInputs inputs_;
  std::string beyond_;         ///< all but the configuration; its names hold a blank, which no key does
  std::string configuration_;  ///< resolved
};

/// What a result file is to a run.
enum class Standing {
  absent,
  damaged,  ///< not, whole and unaltered, what this program wrote
  other,    ///< of another run
  complete  ///< of this run
};
struct FoundResult {
  Standing standing = Standing::absent;
  std::string problem;  ///< what is damaged, or how the other run differs
};
FoundResult find_result(const std::filesystem::path& file, const RunIdentity& identity);

/// For messages about what cannot be gone on with.
inline constexpr const char* begin_anew =
    "give the options that it was made with, begin the point anew with --afresh, which deletes it, or choose another "
    "folder with --output";

}  // namespace flowslide
