// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "dem/engine.hpp"
#include "dem/native/body.hpp"
#include "dem/native/motion_pass.hpp"
#include "dem/native/share.hpp"
#include "dem/stress_sums.hpp"
#include "dem/uniform_flow.hpp"

namespace flowslide::native {

/// Moves the cell and adds what planes and drag do to the mobile grains of a share.
class Boundaries {
 public:
  Boundaries(const Cell& cell, const EngineSettings& settings, const Share& share)
      : cell_(cell), settings_(settings), share_(share) {}

  void set(const EngineSettings& settings) { settings_ = settings; }
  void move(const BoundaryMotion& motion);
  /// Advances planes and periods by a step.
  void advance();
  /// Whether the sides move, or the faces of a cell that is periodic along z.
  bool compresses() const;
  /// Whether the last step brought another image above the cell next to it, so that images are numbered anew.
  bool renumbers() const { return renumbers_; }
  /// Whether a period changes, so that `advance` must be followed by `carry`.
  bool carries() const;
  /// A step of shrinking periods carries the share's grains affinely.
  void carry(std::vector<Body<double>>& bodies) const;
  /// Notes the mobile grains that are nearer to a plane than `skin` (m): only they can meet one before the next call.
  void find_near(const std::vector<Body<double>>& bodies, const std::vector<Role>& role, double skin);
  /// Adds the forces of planes and drag to the loads of the mobile grains of a part of the share.
  template <typename Real>
  void push(const Share& part, const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
            std::vector<Load<Real>>& loads) const;
  /// Takes the moments of drag on the mobile grains of the share out of `sums`. Velocities are those of the half step.
  void remove_drag_moments(const std::vector<Body<double>>& bodies, const std::vector<Role>& role,
                           StressSums& sums) const;
  /// Adds the forces of the upper planes on the grains, each along its axis, N.
  void add_upper_plane(const std::vector<Body<double>>& bodies, Vector3& force) const;

  const Cell& cell() const { return cell_; }
  const EngineSettings& settings() const { return settings_; }
  const BoundaryMotion& motion() const { return motion_; }
  /// Linear field of velocities that the boundaries impose on the grains, without the compression of rigid sides.
  MeanFlow mean_flow() const;
  /// Bound on how fast two grains, or a grain and a plane along z, meet that follow the mean flow and shrinking periods
  /// and are `reach` (m) apart, m/s.
  double mean_flow_speed(double reach) const;
  /// Speed of the fastest rigid side, m/s: grains do not follow it.
  double side_speed() const;
  /// What grains must be folded back into: the cell, open along rigid axes.
  Box periods() const;
  /// What grains must stay in: the cell, open (but finite) along periodic axes.
  Box confines() const;

 private:
  bool moves_faces() const;
  struct Near {
    std::uint32_t grain;
    std::uint8_t axis;
    bool upper;
  };
  /// Force of a plane on a grain near it, along the axis, N.
  double push_of(const Near& near, const Body<double>& body) const;
  /// Drag on a mobile grain, relative to that flow, N.
  Vector3 drag_on(const Body<double>& body, const UniformFlow& flow) const;

  Cell cell_;
  EngineSettings settings_;
  Share share_;
  BoundaryMotion motion_;
  double lower_before_ = 0.0, height_before_ = 0.0;  ///< of the cell before the last step, m
  bool renumbers_ = false;
  std::vector<Near> near_;  ///< by grain, axis and side
};

}  // namespace flowslide::native
