// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

#include "grains/assembly.hpp"

namespace flowslide {

/// What a sample is like beyond its mean void ratio, as tables for gnuplot in `folder`:
///   <name>_slices_x.dat, _y, _z  void ratios of slices of a mean diameter over their place across the axis, 0 to 1;
///                                their mean without wall layers, less and plus two standard deviations of counting
///   <name>_distances.dat         radial distribution function up to 3 mean diameters, or half of a periodic length
///   <name>_contacts.dat          shares of the mobile grains over their number of contacts
/// The sample must be periodic along x and y. Errors: those of write_table and of the measures.
void write_sample_tables(const std::filesystem::path& folder, const std::string& name, const Assembly& sample);

}  // namespace flowslide
