// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "coupling/slide.hpp"
#include "coupling/stop.hpp"
#include "program/case.hpp"
#include "sample/preparation.hpp"
#include "sample/specification.hpp"

namespace flowslide {

/// The settings of all scenes, from case.toml.
struct SceneSettings {
  std::optional<Configuration> configuration;  ///< the whole configuration, for scenes that read settings like a user
  std::vector<InputTable> inputs;              ///< tables read from files that the configuration names
  std::string engine;
  std::int64_t seed = 1;
  SlopeProperties slope;
  Material material;
  SampleRecipe loose, dense;  ///< from [sample.loose] and [sample.dense]
  bool allow_uneven = false;  ///< see SampleSpecification
  std::int64_t seeds = 3;     ///< number of samples in scenes that need several
  double shear_rate = 0.5;    ///< quasi-static rate, 1/s
  std::int64_t rest_steps = 10'000'000;  ///< steps of the scene at rest
  std::array<int, 3> large_lattice{};  ///< grains along x, y, z in the scene with many grains; 0: no such scene

  /// Reads the whole configuration. Throws ConfigurationError.
  static SceneSettings read(const Configuration& configuration);
};

/// Provides samples, engines and settings of slides for the scenes.
class SceneContext {
 public:
  SceneContext(const SceneSettings& settings, const PointRun& run) : settings_(settings), run_(run) {}

  const SceneSettings& settings() const { return settings_; }
  /// The recipe of the sample with number `sample` (from 0): `recipe` with its seed shifted.
  static SampleRecipe numbered(SampleRecipe recipe, std::int64_t sample);
  /// The sample of a recipe, from the cache or by a preparation. If a packing collapses, the next seed is tried.
  PreparedSample prepared(const SampleRecipe& recipe) const;
  std::unique_ptr<Engine> engine() const;
  /// A checkpoint opportunity: throws if the run is to stop (see PointCheckpoints). Scenes write no checkpoints; a
  /// stopped scene starts from its beginning.
  void stop_if_due() const {
    run_.checkpoints.poll_in_preparation([] { return false; });
  }
  /// The settings that a user gets on this slope with these lines of TOML in the tables [coupling] and [loading] of a
  /// case. Throws ConfigurationError as for a user.
  SlideSettings slide(const std::string& coupling, const std::string& loading, const SlopeProperties& slope) const;

 private:
  const SceneSettings& settings_;
  const PointRun& run_;
};

}  // namespace flowslide
