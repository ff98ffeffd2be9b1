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

/// What case.toml says of the suite.
struct Suite {
  std::optional<Configuration> configuration;  ///< all of it, for scenes that go through the door of a user
  std::vector<InputTable> inputs;              ///< tables that it names
  std::string engine;
  std::int64_t seed = 1;
  SlopeProperties slope;
  Material material;
  SampleRecipe loose, dense;  ///< from [sample.loose] and [sample.dense]
  bool allow_uneven = false;  ///< see SampleSpecification
  std::int64_t seeds = 3;     ///< samples of each kind where a scene needs several
  double shear_rate = 0.5;    ///< quasi-static, 1/s
  std::int64_t rest_steps = 10'000'000;
  std::array<int, 3> large_lattice{};  ///< of the scene with many grains; empty counts leave it out

  /// Reads the whole of it. Throws ConfigurationError.
  static Suite read(const Configuration& configuration);
};

/// What scenes work with: samples, engines and settings of slides.
class Workshop {
 public:
  Workshop(const Suite& suite, const PointRun& run) : suite_(suite), run_(run) {}

  const Suite& suite() const { return suite_; }
  /// `recipe` with the seed of sample number `sample`, from 0.
  static SampleRecipe numbered(SampleRecipe recipe, std::int64_t sample);
  /// The sample of a recipe, from the cache or prepared now; a packing that collapses is replaced by the next seed's.
  PreparedSample prepared(const SampleRecipe& recipe) const;
  std::unique_ptr<Engine> engine() const;
  /// Ends the run here if it is to stop (see PointCheckpoints); a scene starts anew the next time.
  void border() const { run_.checkpoints.border_of_preparation([] { return false; }); }
  /// What a user gets who writes these lines of TOML into the tables [coupling] and [loading] of a case, on this slope.
  /// Throws ConfigurationError as for the user.
  SlideSettings slide(const std::string& coupling, const std::string& loading, const SlopeProperties& slope) const;

 private:
  const Suite& suite_;
  const PointRun& run_;
};

}  // namespace flowslide
