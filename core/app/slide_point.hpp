// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/case_program.hpp"
#include "app/models.hpp"
#include "app/profile_record.hpp"
#include "app/slide_run.hpp"

namespace flowslide {

/// One slide of a case, or a replicate of it on another sample: a table [point.<name>].
struct SlidePoint {
  Point point;                 ///< named after the table, and the replicate
  std::string name;            ///< of the table
  int replicate = 0;           ///< from 0
  SampleSpecification sample;
  SlideSettings settings;
  StopConditions stop;
  RowSpacing rows;
  ProfilePlan profiles;        ///< without strains none are taken
};

/// Reads [point.<name>]: figures, sample (a key below [sample]), scheme (a key below [scheme]), hydraulic_conductivity
/// and profile_strains if there. Its tables coupling, loading, stop and rows stand in front of those at the top, and
/// [scheme.<scheme>] between those of coupling. `samples` are those of the replicate; `engine` is that of the slide, a
/// closed-form sample among them, and decides the predicted time. Throws ConfigurationError.
SlidePoint read_slide_point(const Configuration& configuration, const std::string& name, int replicate,
                            const std::vector<SampleSpecification>& samples, const SlopeProperties& slope,
                            const std::string& engine, const std::filesystem::path& folder);

/// Local steps that a slide would take on a sample without strength: about as many as it takes at most.
double predicted_steps(const SlideSettings& settings, const StopConditions& stop);

}  // namespace flowslide
