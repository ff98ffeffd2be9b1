// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "experiment/profile_record.hpp"
#include "experiment/shear_test.hpp"
#include "experiment/slide_run.hpp"
#include "program/case.hpp"
#include "sample/specification.hpp"

namespace flowslide {

/// One replicate of a slide or of an element test: a table [point.<name>] of a case.
struct SlidePoint {
  Point point;                 ///< its name is that of the table with the number of the replicate
  std::string name;            ///< name of the table
  int replicate = 0;           ///< from 0
  SampleSpecification sample;
  GrainScale grains;           ///< of the packing with which the search starts; after on_sample those of the sample
  std::string engine;          ///< name of the engine or of the closed-form sample
  std::optional<ShearTest> test;  ///< the element test in place of a slide; needs a DEM sample
  SlideSettings settings;           ///< for an element test only the local time step is used
  bool linear_start = false;        ///< see DemSample::start_linear_at_first_strain
  StopConditions stop;
  RowSpacing rows;
  ProfilePlan profiles;        ///< without strains no profile is taken
  std::vector<Metric> parameters;  ///< parameters for its result (see slide_parameters.hpp)
  bool published = true;  ///< the case has this point; false: the user added it
  /// Makes the closed-form sample of a slide; empty with a DEM engine.
  std::function<std::unique_ptr<Sample>()> closed_form = {};
};

/// What all points of one replicate of a case share.
struct CommonSettings {
  int replicate = 0;                              ///< from 0
  std::vector<SampleSpecification> samples = {};  ///< of this replicate
  SlopeProperties slope = {};
  std::string engine;  ///< name of the engine or of the closed-form sample of the case
};

/// Reads the table [point.<name>]. Keys of a slide: figures; sample, a name below [sample]; scheme, a name below
/// [scheme]; and optionally hydraulic_conductivity, profile_strains and engine.
/// - Order of lookup for coupling: [point.<name>.coupling], [scheme.<scheme>], [coupling]. It includes the optional
///   key linear_start.
/// - Order of lookup for loading, stop and rows: [point.<name>.loading], then [loading], and so on.
/// - With the key final_strain the point is an element test, which has no scheme. Keys of the test that the point does
///   not have are read from [shear_test] (see read_shear_test), the local time step as above from coupling.
/// - With `like = "other"`, keys that the point does not have are read from [point.other], its tables included.
/// - The key engine replaces the engine of the case, unless that is a closed-form sample.
/// The predicted time depends on the engine. Throws ConfigurationError.
SlidePoint read_slide_point(const Configuration& configuration, const std::string& name, const CommonSettings& common);

/// The point for the sample that was found. Strain rates that are given by an inertial number are computed with the
/// mean diameter of this sample, m.
SlidePoint on_sample(SlidePoint point, double mean_diameter);

/// Number of local steps of a slide on a sample without strength. A slide needs about this number at most.
double predicted_steps(const SlideSettings& settings, const StopConditions& stop);

}  // namespace flowslide
