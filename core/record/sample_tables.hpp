// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

#include "grains/assembly.hpp"

namespace flowslide {

/// Writes the structure of a sample as tables for gnuplot in `folder`:
///   <name>_slices_x.dat, _y, _z  void ratio of each slice, one mean diameter thick, over its position along the axis
///                                (0 to 1); and the band of a random packing: the mean without wall layers, minus and
///                                plus two standard deviations (see counting_deviation)
///   <name>_distances.dat         radial distribution function up to 3 mean diameters or half of a periodic length
///   <name>_contacts.dat          fraction of the mobile grains over their number of contacts
/// The sample must be periodic along x and y. Throws as write_table and as the measures.
void write_sample_tables(const std::filesystem::path& folder, const std::string& name, const Assembly& sample);

}  // namespace flowslide
