// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "run/checkpoint.hpp"
#include "run/output_folder.hpp"

namespace flowslide {

/// Strains of the frames: equally spaced from 0 to `strain`.
std::vector<double> frame_strains(double strain);

/// Writes the files of Fig. 2. `shots` are the states of the sample, at least one.
///   fig02_before.dat, fig02_during.dat   the sample in the first and in the last state
///   fig02_...                            tables of the sample before shear (see write_sample_tables)
///   <name>.pvd                           all states for ParaView, with its .vtp files in <name>_frames
void write_frames(const OutputFolder& output, const std::string& name, const std::vector<Shot>& shots);

}  // namespace flowslide
