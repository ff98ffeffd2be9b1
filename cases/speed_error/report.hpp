// SPDX-License-Identifier: GPL-2.0-or-later
// The report on speed against error: tables in Markdown, for gnuplot and in HDF5, and the recommended settings.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "error_table.hpp"

namespace flowslide {

/// Cost of a scene with LIGGGHTS and the settings of the paper, on one core.
struct PaperCost {
  double grains = 0.0, steps = 0.0;
  double seconds_per_grain_step = 0.0;  ///< s, measured with LIGGGHTS at the grains and the time step of this scale
  double seconds() const { return grains * steps * seconds_per_grain_step; }
};

/// The content of the report.
struct Report {
  std::vector<SettingError> errors;                   ///< see errors_of
  std::map<Scene, std::vector<Candidate>> candidates;  ///< see candidates_of
  std::map<Scene, PaperCost> paper;                    ///< for scenes with a result of LIGGGHTS
};

/// The name of a setting without the name of its scene; "base" for the setting that is named after the scene.
std::string label_of(const std::string& setting, Scene scene);

/// One table for each scene in Markdown, sorted by cost, and the recommendations below the tables.
std::string markdown(const Report& report);

/// Writes table.md, for each scene errors_<scene>.dat (label, axis, seconds, grain steps, error over spread, whether that
/// is below the noise: 1 or 0; rows without an error are left out) and <scene>_front.dat, paper.dat (scene, seconds with
/// LIGGGHTS at the paper's settings), and table.h5 with all of it, sealed as results are. Text has '_' for each blank.
void write_report(const std::filesystem::path& folder, const Report& report);

}  // namespace flowslide
