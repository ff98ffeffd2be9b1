// SPDX-License-Identifier: GPL-2.0-or-later
// What differs between the programs of the cases, and what a run of one is given.
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

/// One run of a case, such as one curve of a figure: the unit that is run, kept and skipped when it is there.
struct Point {
  std::string name;                   ///< also of its files: <name>.h5, <name>.dat
  std::vector<std::string> figures;   ///< of the paper that draw it, "3"
  std::string description;
  double predicted_seconds = 0.0;     ///< on one core, with its samples in the cache
  std::string sample = {};            ///< the prepared sample that it needs, in letters, digits and "_"; empty: none
  RunInputs inputs = {};              ///< what else decides its result
  std::vector<std::string> tables = {};  ///< names, without an ending, of what it writes beside files of its own name
};

/// What a point needs to be run.
struct PointRun {
  const OutputFolder& output;
  Provenance provenance;  ///< complete but for seed and replicate
  const RunIdentity& identity;
  ProgressStyle progress;
  int threads;                        ///< of the native engines; 0: they decide
  PointCheckpoints& checkpoints;      ///< what it goes on from, and to be asked at each border between exchanges
  std::clock_t begun = std::clock();

  /// `provenance` with what the point has cost so far: that of its checkpoint, and of this process since it `begun`,
  /// for each of its ranks, which wait for each other.
  Provenance provenance_now() const;
  /// What is written of the point: these rows and numbers, with their origin. Lacks seed and replicate.
  Result result(Series series, std::vector<Metric> metrics) const;
};

/// A case of the paper: what differs between their programs.
class Case {
 public:
  virtual ~Case() = default;
  virtual CaseDescription description() const = 0;
  /// Reads all that the configuration may hold. Called once, before the rest.
  virtual void read(const Configuration& configuration) = 0;
  virtual std::vector<Point> points() const = 0;
  /// Names, without an ending, of what finish() writes: no point may be named so.
  virtual std::vector<std::string> tables() const { return {}; }
  /// What a point would do: engine commands, steps, time. For --dry-run. Collective over the MPI
  /// ranks, as engines are made by all of them; `out` shows what the first writes.
  virtual void print_plan(const Point& point, std::ostream& out) const = 0;
  /// Prepares the sample of a point for the cache, or finds it there. Collective over the MPI ranks.
  virtual void prepare(const Point&, const ProgressStyle&, const PreparationBorder&) const {}
  /// Runs a point, from where its checkpoints say, and writes its files, <point>.h5 last: a point is complete with
  /// that, and its checkpoints go. Collective over the MPI ranks.
  virtual void run(const Point& point, const PointRun& run) const = 0;
  /// The numbers that claims are about, from the files of these points. A number that does not exist is left out, and a
  /// claim about it is not evaluated.
  virtual std::map<std::string, double> metrics(const std::filesystem::path& folder,
                                                const std::vector<std::string>& points) const = 0;
  /// Writes what the figures need besides the tables of the points, from the points that OutputFolder::has_result.
  /// Called before claims are checked.
  virtual void finish(const OutputFolder&) const {}
};

/// The case of a program. Each folder under cases/ defines this function once.
std::unique_ptr<Case> make_case();

}  // namespace flowslide
