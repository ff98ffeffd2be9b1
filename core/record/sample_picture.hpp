// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <vector>

#include "grains/assembly.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {

/// View of a sample: parallel projection, z upwards.
struct View {
  double azimuth = -65.0;        ///< angle of the viewer about z from the x axis, degrees; at -90 x points to the right
  double elevation = 20.0;       ///< degrees above the horizontal
  double shear_strain = 0.0;     ///< gamma of the cell in the picture; grains are folded into this sheared cell
  int shells = 6;                ///< circles per grain, from its rim to its highlight, >= 1
};

/// One circle of the picture. A grain consists of `shells` circles, which become smaller and brighter towards the
/// light.
struct Disc {
  double across = 0.0, up = 0.0;  ///< m, centre in the plane of the picture
  double radius = 0.0;            ///< m
  double shade = 0.0;             ///< 0 (dark) to 1 (bright)
  Role role = Role::mobile;
};

/// The circles of the visible grains, in drawing order (back to front). Throws std::invalid_argument for a grain that
/// is not finite, for a radius <= 0, and for less than one shell.
std::vector<Disc> draw_grains(const Assembly& assembly, const View& view = {});

/// Writes the picture as a table (see table_head), whole or not at all: a row for each disc, then two for each edge of
/// the cell, with an empty line behind each edge. Columns: across, up, radius (m), shade, part. `part` is 0 for mobile
/// grains, 1 and 2 for glued grains at the bottom and at the top, 3 for edges in front of the grains, and 4 for edges
/// behind the grains. Plot the edges behind first and those in front last. Throws as draw_grains and write_atomically.
void write_picture(const std::filesystem::path& path, const Assembly& assembly, const View& view = {});

}  // namespace flowslide
