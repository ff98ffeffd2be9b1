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

/// Writes the report. In the .dat files '_' replaces each blank of a text.
///   table.md             see markdown
///   errors_<scene>.dat   label, axis, seconds, grain steps, error/spread, and 1 if this ratio is at most 1, else 0;
///                        rows without an error are left out
///   <scene>_front.dat    the candidates on the front
///   paper.dat            scene, seconds with LIGGGHTS at the settings of the paper
///   table.h5             all of these, sealed as results are
void write_report(const std::filesystem::path& folder, const Report& report);

}  // namespace flowslide
