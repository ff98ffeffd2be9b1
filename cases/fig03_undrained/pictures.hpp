// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "run/checkpoint.hpp"
#include "run/output_folder.hpp"

namespace flowslide {

/// Strains of the frames up to `strain`, evenly from 0.
std::vector<double> frame_strains(double strain);

/// Writes what Fig. 2 shows: fig02_before.dat and fig02_during.dat, the sample at the first and at the last of the shots;
/// the tables of the sample before shear (see write_sample_tables); and all shots for ParaView, <name>.pvd with its .vtp
/// files in <name>_frames.
void write_frames(const OutputFolder& output, const std::string& name, const std::vector<Shot>& shots);

}  // namespace flowslide
