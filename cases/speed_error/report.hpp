// SPDX-License-Identifier: GPL-2.0-or-later
// What is said of speed against error: tables for people, for gnuplot and as HDF5, and the recommendation.
#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "error_table.hpp"

namespace flowslide {

/// What a scene takes with LIGGGHTS at the paper's own settings, on one core.
struct PaperCost {
  double grains = 0.0, steps = 0.0;
  double seconds_per_grain_step = 0.0;  ///< as measured on LIGGGHTS with the grains and time step of this scale, s
  double seconds() const { return grains * steps * seconds_per_grain_step; }
};

/// Everything that is reported.
struct Report {
  std::vector<SettingError> errors;                   ///< see errors_of
  std::map<Scene, std::vector<Candidate>> candidates;  ///< see candidates_of
  std::map<Scene, PaperCost> paper;                    ///< of the scenes where LIGGGHTS has run
};

/// The name of a setting without that of its scene; "base" for the scene's own.
std::string label_of(const std::string& setting, Scene scene);

/// One table for each scene, by cost, in Markdown, and the recommendations below it.
std::string markdown(const Report& report);

/// Writes table.md, for each scene errors_<scene>.dat (label, axis, seconds, grain steps, error over spread, whether that
/// is below the noise: 1 or 0; rows without an error are left out) and <scene>_front.dat, paper.dat (scene, seconds with
/// LIGGGHTS at the paper's settings), and table.h5 with all of it, sealed as results are. Text has '_' for each blank.
void write_report(const std::filesystem::path& folder, const Report& report);

}  // namespace flowslide
