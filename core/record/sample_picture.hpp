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

/// Writes the picture for gnuplot, whole or not at all, in three blocks:
///   index 0: one circle per row; columns across, up, radius (m), shade, role:
///            `plot FILE index 0 using 1:2:3:(COLOUR of 4 and 5) with circles fillcolor rgb variable fill solid`
///   index 1: edges of the cell in front of the grains, two rows and an empty row each; columns across, up (m):
///            `plot FILE index 1 using 1:2 with lines`
///   index 2: edges behind the grains, likewise; plot them first.
/// Throws as draw_grains and write_atomically.
void write_picture(const std::filesystem::path& path, const Assembly& assembly, const View& view = {});

}  // namespace flowslide
