// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "grains/assembly.hpp"
#include "record/atomic_file.hpp"

namespace flowslide {

/// `position` (m) moved by whole cell lengths into the cell, along its periodic axes.
Vector3 folded(const Cell& cell, Vector3 position);

/// The twelve edges of the cell, shape (12, 2) points, m: along x, then y, then z, each from lower to upper.
std::vector<Vector3> cell_edges(const Cell& cell);

/// Writes the grains as VTK PolyData (.vtp), one point each, for ParaView ("Point Gaussian", or Glyph: sphere scaled by
/// `diameter`): arrays radius, diameter (m), velocity (m/s), spin (rad/s), role (0 mobile, 1 bottom, 2 top layer), in
/// single precision, positions folded into the periodic cell. Writes whole or not at all.
void write_grains(const std::filesystem::path& path, const Assembly& assembly);

/// Writes the twelve edges of the cell as VTK PolyData (.vtp).
void write_cell(const std::filesystem::path& path, const Cell& cell);

/// One file of an animation.
struct Frame {
  double time = 0.0;   ///< s
  std::string file;    ///< relative to the collection
  int part = 0;        ///< 0 grains, 1 cell: frames of one time
};

/// Writes a ParaView collection (.pvd) of `frames`, whole or not at all.
void write_collection(const std::filesystem::path& path, std::span<const Frame> frames);

}  // namespace flowslide
