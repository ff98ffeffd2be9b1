// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// Status of a run in an output folder.
struct PointStatus {
  std::string point;        ///< name of the run
  std::string state;        ///< complete, damaged, outdated (a result or checkpoint of another identity), running,
                            ///< stopped (with a checkpoint), begun (without one) or not begun
  std::string place;        ///< state of its last checkpoint in one line, or the difference of the other identity
  double share_done = 0.0;  ///< estimated fraction done at its last checkpoint, 0 to 1; 1 if complete
  double age = 0.0;        ///< age of its last checkpoint, s; 0 without one
  std::string sample = {};  ///< health of its sample, see health_line; empty before the first checkpoint
};

/// Reads the status of the run `point` and changes nothing; the run may be running. `identity` is its required
/// identity.
PointStatus status_of(const OutputFolder& output, const std::string& point, const RunIdentity& identity);

/// A header and a line for each run, then a line for each known sample.
std::string status_table(const std::vector<PointStatus>& points);
/// {"points": [{"name": "RD", "state": "running", "share_done": 0.42, "checkpoint_age": 12.0, "place": "...",
/// "sample": "e0 0.7823 ..."}, ...]}
std::string status_json(const std::vector<PointStatus>& points);

}  // namespace flowslide
