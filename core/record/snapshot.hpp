// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "grains/assembly.hpp"
#include "record/atomic_file.hpp"

namespace flowslide {

/// `position` (m), moved into the cell by whole periods along its periodic axes.
Vector3 folded(const Cell& cell, Vector3 position);

/// End points of the twelve edges of the cell, shape (12, 2) points, m: edges along x, then y, then z, each from the
/// lower to the upper end.
std::vector<Vector3> cell_edges(const Cell& cell);

/// Writes the grains as VTK PolyData (.vtp) for ParaView, whole or not at all; show them as "Point Gaussian", or as
/// Glyph: sphere scaled by `diameter`. One point per grain, folded into the periodic cell, in single precision. Arrays:
/// radius, diameter (m), velocity (m/s), spin (rad/s), role (0 mobile, 1 bottom layer, 2 top layer).
void write_grains(const std::filesystem::path& path, const Assembly& assembly);

/// Writes the twelve edges of the cell as VTK PolyData (.vtp).
void write_cell(const std::filesystem::path& path, const Cell& cell);

/// One file of an animation.
struct Frame {
  double time = 0.0;   ///< s
  std::string file;    ///< relative to the collection
  int part = 0;        ///< distinguishes frames of one time: 0 grains, 1 cell
};

/// Writes a ParaView collection (.pvd) of `frames`, whole or not at all. Throws std::invalid_argument for a time that
/// is not finite.
void write_collection(const std::filesystem::path& path, std::span<const Frame> frames);

}  // namespace flowslide
