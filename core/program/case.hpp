// SPDX-License-Identifier: GPL-2.0-or-later
// The interface of a case, and the data that the case program gives to each of its runs.
#pragma once
#include <ctime>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "process/progress.hpp"
#include "program/command_line.hpp"
#include "record/result_file.hpp"
#include "run/output_folder.hpp"
#include "run/point_checkpoints.hpp"
#include "run/run_identity.hpp"
#include "sample_library/preparation_checkpoints.hpp"

namespace flowslide {

/// One run of a case, such as one curve of a figure. A run is started, checkpointed and stored as a unit, and skipped
/// if its result exists.
struct Point {
  std::string name;                   ///< also the name of its files: <name>.h5, <name>.dat
  std::vector<std::string> figures;   ///< numbers of the paper's figures that show it, such as "3"
  std::string description;
  double predicted_seconds = 0.0;     ///< processor time on one core if its samples are in the cache, s
  std::string sample = {};            ///< label of its prepared sample: letters, digits and "_"; empty: none
  RunInputs inputs = {};              ///< other inputs that decide its result
  std::vector<std::string> tables = {};  ///< names, without extension, of its other files, such as "<name>_profiles"
  std::string curve = {};             ///< name that its replicates share; empty: `name`
  int grains = 0;                     ///< number of grains of its sample; 0: a closed-form sample, or several samples
  std::string configuration = {};  ///< the part of the resolved configuration that decides its result; empty: all
};

/// The data and services for one run.
struct PointRun {
  const OutputFolder& output;
  Provenance provenance;  ///< complete except seed, replicate and sample
  const RunIdentity& identity;
  ProgressStyle progress;
  int threads;                        ///< number of threads of a native engine; 0: the engine decides
  PointCheckpoints& checkpoints;      ///< the state to continue from; call its poll() after each exchange
  std::clock_t begun = std::clock();  ///< processor time of this process at the start of the run

  /// `provenance` with the processor time used so far: that stored in the checkpoint, plus that of this process since
  /// `begun` times the number of MPI ranks. All ranks use the same time, because they wait for each other.
  Provenance provenance_now() const;
  /// A result of the run with this series, these metrics, provenance and identity. Seed, replicate and sample are left
  /// to the case.
  Result result(Series series, std::vector<Metric> metrics) const;
};

/// A case: one folder below cases/. Its program calls the functions below (see run_case). A folder without claims.toml
/// has no claims of the paper, and no settings of the paper to differ from.
class Case {
 public:
  virtual ~Case() = default;
  virtual CaseDescription description() const = 0;
  /// Reads every key that the configuration may have. The program calls it once, before the other functions.
  virtual void read(const Configuration& configuration) = 0;
  virtual std::vector<Point> points() const = 0;
  /// Names, without extension, of the files that finish() writes. No run may have one of these names.
  virtual std::vector<std::string> tables() const { return {}; }
  /// Prints the plan of a run for --dry-run: engine commands and steps. Collective over the MPI ranks, because all
  /// ranks make the engine; only the output of the first rank is shown.
  virtual void print_plan(const Point& point, std::ostream& out) const = 0;
  /// Finds the sample of a run in the cache, or prepares it on `threads` threads (0: as many as suit its size) and
  /// stores it there. Collective over the MPI ranks.
  virtual void prepare(const Point&, int /*threads*/, const ProgressStyle&, const PreparationPoll&) const {}
  /// Runs a point from its last checkpoint, or from the start, and writes its files. <point>.h5 is written last: with
  /// it the run is complete, and the program deletes its checkpoints. Collective over the MPI ranks.
  virtual void run(const Point& point, const PointRun& run) const = 0;
  /// The metrics that claims are evaluated from, read from the files of these runs. A metric that does not exist is
  /// left out; a claim about it is not evaluated.
  virtual std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                                const std::vector<std::string>& points) const = 0;
  /// Writes the files that the figures need beside the tables of the runs, from all runs with OutputFolder::has_result.
  /// The program calls it before it evaluates claims.
  virtual void finish(const OutputFolder&) const {}
};

/// Makes the case of this program. Each folder below cases/ defines this function once.
std::unique_ptr<Case> make_case();

}  // namespace flowslide
