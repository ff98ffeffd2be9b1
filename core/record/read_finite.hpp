// SPDX-License-Identifier: GPL-2.0-or-later
// Reading what a run goes on from: numbers that are not finite are refused.
#pragma once
#include <cstdint>
#include <string>

#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// read_assembly, and CorruptFileError for grains or contacts that are not finite or a cell without volume.
Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name);

/// Reads a number that is an attribute: finite, and not negative where it is whole, or CorruptFileError.
struct ReadNumber {
  const hdf5::Group& group;
  void operator()(const char* name, double& value) const;
  void operator()(const char* name, std::int64_t& value) const;
};

}  // namespace flowslide
