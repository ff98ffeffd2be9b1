// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "experiment/profile_record.hpp"
#include "experiment/shear_test.hpp"
#include "experiment/slide_run.hpp"
#include "program/case.hpp"
#include "sample/specification.hpp"

namespace flowslide {

/// One slide of a case, or an element test beside it, or a replicate on another sample: a table [point.<name>].
struct SlidePoint {
  Point point;                 ///< named after the table, and the replicate
  std::string name;            ///< of the table
  int replicate = 0;           ///< from 0
  SampleSpecification sample;
  GrainScale grains;           ///< of the packing that the search begins with, or of the sample: see on_sample
  std::string engine;          ///< or closed-form sample
  std::optional<ShearTest> test;  ///< of the sample alone, in place of a slide; it needs grains
  SlideSettings settings;           ///< of a test, the local time step alone
  bool linear_start = false;        ///< see DemSample::start_linear_at_first_strain
  StopConditions stop;
  RowSpacing rows;
  ProfilePlan profiles;        ///< without strains none are taken
  /// What it was given, as numbers for its result (see slide_parameters.hpp).
  std::vector<Metric> parameters;
  bool published = true;  ///< the case has it; else --config or --set has added it
};

/// Reads [point.<name>]: figures, sample (a key below [sample]), scheme (a key below [scheme]), hydraulic_conductivity
/// and profile_strains if there. Its tables coupling, loading, stop and rows stand in front of those at the top, and
/// [scheme.<scheme>] between those of coupling, which may have linear_start. With final_strain in place of scheme it is
/// an element test: [element_test] has what the point leaves out (see read_shear_test), coupling the time step.
/// What the table leaves out is read from that of the point that it is `like`, if it is like one.
/// A key `engine` of the point stands in front of `engine`, that of the case, unless this is a closed-form sample.
/// `samples` are those of the replicate; the engine decides the predicted time. Throws ConfigurationError.
SlidePoint read_slide_point(const Configuration& configuration, const std::string& name, int replicate,
                            const std::vector<SampleSpecification>& samples, const SlopeProperties& slope,
                            const std::string& engine);

/// The point on the sample that was found for it, whose mean diameter (m) decides the rates that follow from an
/// inertial number.
SlidePoint on_sample(SlidePoint point, double mean_diameter);

/// Local steps that a slide would take on a sample without strength: about as many as it takes at most.
double predicted_steps(const SlideSettings& settings, const StopConditions& stop);

}  // namespace flowslide
