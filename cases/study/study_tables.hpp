// SPDX-License-Identifier: GPL-2.0-or-later
// The tables of the figure of a study, for plots/study.gp.
#pragma once
#include <string>
#include <vector>

#include "experiment/ensemble.hpp"
#include "run/output_folder.hpp"
#include "study_run.hpp"

namespace flowslide {

/// What the tables say of a study.
struct StudyFigure {
  std::string case_name;
  std::string engine;                ///< "native, 1100 grains"
  std::vector<std::string> schemes;  ///< in the order of the configuration
  Sweep sweep;
  std::vector<StudyRun> runs;
};

/// Whether the swept key changed nothing: a scheme has results of several values, and the rows of each sample are the
/// same for all values.
bool is_sweep_without_effect(const StudyFigure& study, const std::string& scheme, const Ensembles& slides);

/// Writes the tables of those runs that have results:
///   slides.dat  one row per run: slide, scheme, the value in the unit of the sweep, number of samples
///   sweep.dat   v_max, peak of tau and runout of each scheme over the swept value (see sweep_series); without rows
///               if there is no sweep
///   legend.txt  label of each run; "x axis": label of the swept key; "note": engine, grains and samples; "x texts" if
///               the swept values are texts, which have numbers in the tables
void write_study_tables(const OutputFolder& output, const StudyFigure& study, const Ensembles& slides);

}  // namespace flowslide
