// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <algorithm>
#include <cmath>
#include <string>

#include "dem/engine.hpp"

namespace flowslide {

/// An engine without contacts: its grains follow the cell, which answers like an elastic block. It goes through the
/// stages of a preparation within milliseconds and ends at the void ratio of a made-up law of friction and seed, less
/// 0.015 of elastic compression.
class ElasticBlock : public Engine {
 public:
  /// The first `collapses` preparations lose a grain.
  explicit ElasticBlock(std::string version = "1", int collapses = 0)
      : version_(std::move(version)), collapses_(collapses) {}

  /// Void ratio at which the block begins to bear stress; `chance` is a number of each packing.
  static double law(double friction, double chance) { return 0.72 + 0.15 * friction + 0.01 * chance; }

  std::int64_t steps() const { return steps_; }       ///< of all preparations
  int preparations() const { return preparations_; }

  void load(const Assembly& assembly, const EngineSettings& settings) override {
    if (assembly.cell.periodic[0] == false) begin(assembly, settings);
    assembly_ = assembly;
    set(settings);
    motion_ = {};
  }
  Assembly save() const override { return assembly_; }
  void set(const EngineSettings& settings) override { settings_ = settings; }
  const EngineSettings& settings() const override { return settings_; }
  void move(const BoundaryMotion& motion) override { motion_ = motion; }
  void run(std::int64_t steps) override {
    steps_ += steps;
    const double time = static_cast<double>(steps) * settings_.time_step;
    const Cell before = assembly_.cell;
    const Vector3 half = 0.5 * time * Vector3(motion_.compression_rate_x * before.lengths().x(),
                                              motion_.compression_rate_y * before.lengths().y(), 0.0);
    Cell& cell = assembly_.cell;
    cell.lower += half + Vector3(0.0, 0.0, time * motion_.bottom_velocity.z());
    cell.upper += -half + Vector3(0.0, 0.0, time * motion_.top_velocity.z());
    for (Vector3& position : assembly_.position)
      position = cell.lower + (position - before.lower).cwiseProduct(cell.lengths()).cwiseQuotient(before.lengths());
    shear_strain_ += time * motion_.top_velocity.x() / cell.height();
  }
  CellStress cell_stress() const override {
    const Vector3 strain = (Vector3::Ones() - assembly_.cell.lengths().cwiseQuotient(edges_)).cwiseMax(0.0);
    return {modulus * strain.z(), 0.3 * modulus * shear_strain_, 0.0, modulus * strain.x(), modulus * strain.y()};
  }
  Cell cell() const override { return assembly_.cell; }
  std::uint64_t count_grains() const override { return assembly_.size() - (preparations_ <= collapses_ ? 1 : 0); }
  std::string name() const override { return "block"; }
  std::string version() const override { return version_; }

 private:
  static constexpr double modulus = 1e7;  // Pa

  void begin(const Assembly& assembly, const EngineSettings& settings) {
    ++preparations_;
    shear_strain_ = 0.0;
    const double chance = std::sin(1e6 * assembly.position.front().x());
    const double volume = (1.0 + law(settings.material.sliding_friction, chance)) * assembly.solid_volume();
    edges_ = assembly.cell.lengths() * std::cbrt(volume / assembly.cell.volume());
  }

  std::string version_;
  int collapses_;
  Assembly assembly_;
  EngineSettings settings_;
  BoundaryMotion motion_;
  Vector3 edges_ = Vector3::Ones();  ///< of the block without stress, m
  double shear_strain_ = 0.0;
  std::int64_t steps_ = 0;
  int preparations_ = 0;
};

}  // namespace flowslide
