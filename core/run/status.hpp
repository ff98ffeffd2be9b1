// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "run/output_folder.hpp"
#include "run/run_identity.hpp"

namespace flowslide {

/// How far a point of an output folder has come.
struct PointStatus {
  std::string point;
  std::string state;        ///< complete, damaged, outdated (a result or a checkpoint of another run), running, stopped
                            ///< (with a checkpoint), begun (without) or not begun
  std::string place;        ///< for people: where its last checkpoint stands, or how the other run differs
  double share_done = 0.0;  ///< about, 0 to 1, at its last checkpoint; 1 if complete
  double age = 0.0;        ///< of the last checkpoint, s; 0 without one
  std::string sample = {};  ///< health of its sample, see health_line; empty before the first checkpoint
};

/// Looks, and changes nothing; points may be running. `identity` is that of the run that is asked for.
PointStatus status_of(const OutputFolder& output, const std::string& point, const RunIdentity& identity);

/// A line for each point under a line of titles, then one for each sample that is known.
std::string status_table(const std::vector<PointStatus>& points);
/// {"points": [{"name": "RD", "state": "running", "share_done": 0.42, "checkpoint_age": 12.0, "place": "...",
/// "sample": "e0 0.7823 ..."}, ...]}
std::string status_json(const std::vector<PointStatus>& points);

}  // namespace flowslide
