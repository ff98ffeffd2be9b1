// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "dem/engine.hpp"
#include "dem/native/body.hpp"
#include "dem/native/motion_pass.hpp"
#include "dem/native/grain_range.hpp"
#include "dem/stress_sums.hpp"
#include "dem/uniform_flow.hpp"

namespace flowslide::native {

/// Moves the cell, and adds the forces of planes and drag to the mobile grains of a range.
class Boundaries {
 public:
  Boundaries(const Cell& cell, const EngineSettings& settings, const GrainRange& range)
      : cell_(cell), settings_(settings), range_(range) {}

  void set(const EngineSettings& settings) { settings_ = settings; }
  void move(const BoundaryMotion& motion);
  /// Advances planes and periods by one step.
  void advance();
  /// Whether the lateral sides move, or the faces of a cell that is periodic along z.
  bool compresses() const;
  /// Whether the last step reduced the shear offset by a period. The numbers of the images then change.
  bool renumbers() const { return renumbers_; }
  /// Whether a period changes. `carry` must then follow `advance`.
  bool carries() const;
  /// Moves the grains of the range affinely with the change of the periods in the last step.
  void carry(std::vector<Body<double>>& bodies) const;
  /// Lists the mobile grains whose gap to a plane is at most `skin` (m): only they can touch it before the next call.
  void find_near(const std::vector<Body<double>>& bodies, const std::vector<Role>& role, double skin);
  /// Adds the forces of planes and drag to the loads of the mobile grains in a part of the range.
  template <typename Real>
  void push(const GrainRange& part, const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
            std::vector<Load<Real>>& loads) const;
  /// Subtracts the moments of drag on the mobile grains of the range from `sums`. Velocities are those of the half
  /// step.
  void remove_drag_moments(const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
                           StressSums& sums) const;
  /// Adds the forces of the upper planes on the grains, each along its axis, N.
  void add_upper_plane(const std::vector<Body<double>>& bodies, Vector3& force) const;

  const Cell& cell() const { return cell_; }
  const EngineSettings& settings() const { return settings_; }
  const BoundaryMotion& motion() const { return motion_; }
  /// The linear velocity field that the boundaries impose on the grains, without the compression of rigid sides.
  MeanFlow mean_flow() const;
  /// Upper bound of the approach velocity, m/s, of two grains, or of a grain and a plane normal to z, at the distance
  /// `reach` (m), if grains follow the mean flow and the changing periods.
  double mean_flow_speed(double reach) const;
  /// Speed of the fastest rigid lateral side, m/s. Grains do not follow it.
  double side_speed() const;
  /// Box into which grains are folded: the cell, infinite along rigid axes.
  Box periods() const;
  /// Box in which grains must stay: the cell, very long (but finite) along periodic axes.
  Box confines() const;

 private:
  bool moves_faces() const;
  struct Near {
    std::uint32_t grain;
    std::uint8_t axis;
    bool upper;
  };
  /// Force of a plane on a grain near it, in the direction of the axis, N.
  double push_of(const Near& near, const Body<double>& body) const;
  /// Drag force on a mobile grain relative to `flow`, N.
  Vector3 drag_on(const Body<double>& body, const UniformFlow& flow) const;

  Cell cell_;
  EngineSettings settings_;
  GrainRange range_;
  BoundaryMotion motion_;
  double lower_before_ = 0.0, height_before_ = 0.0;  ///< lower end and height of the cell before the last step, m
  bool renumbers_ = false;
  std::vector<Near> near_;  ///< sorted by grain, axis and side
};

}  // namespace flowslide::native
