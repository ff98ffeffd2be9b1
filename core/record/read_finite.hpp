// SPDX-License-Identifier: GPL-2.0-or-later
// Reading of checkpoints: refuses numbers that are not finite.
#pragma once
#include <cstdint>
#include <string>

#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// As read_assembly. Throws CorruptFileError also for grains or contacts that are not finite, for a radius that is not
/// positive, and for a cell without volume.
Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name);

/// Reads a number from an attribute. Throws CorruptFileError if a double is not finite or if an integer is negative.
struct ReadNumber {
  const hdf5::Group& group;
  void operator()(const char* name, double& value) const;
  void operator()(const char* name, std::int64_t& value) const;
};

}  // namespace flowslide
