// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <vector>

#include "grains/assembly.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {

/// From where a sample is seen: parallel projection, z upwards.
struct View {
  double azimuth = -65.0;        ///< degrees, of the viewer about z from the x axis; at -90 x points to the right
  double elevation = 20.0;       ///< degrees above the horizontal
  double shear_strain = 0.0;     ///< gamma of the drawn cell: grains are folded into the sheared cell
  int shells = 6;                ///< circles per grain, from its rim to its highlight, >= 1
};

/// One circle of the picture. A grain is `shells` circles, ever smaller and brighter towards the light.
struct Disc {
  double across = 0.0, up = 0.0;  ///< m, centre in the plane of the picture
  double radius = 0.0;            ///< m
  double shade = 0.0;             ///< 0 (dark) to 1 (bright)
  Role role = Role::mobile;
};

/// The grains that can be seen, in the order in which to draw them (back to front).
std::vector<Disc> draw_grains(const Assembly& assembly, const View& view = {});

/// Writes the picture as a table (see table_head), whole or not at all: a row for each disc, then two for each edge of
/// the cell, with an empty line behind each edge. Columns: across, up, radius (m), shade, part. `part` tells mobile
/// grains (0), glued grains (1 below, 2 above) and edges (3 in front of the grains, 4 behind them). Edges behind are to
/// be drawn first, those in front last.
void write_picture(const std::filesystem::path& path, const Assembly& assembly, const View& view = {});

}  // namespace flowslide
