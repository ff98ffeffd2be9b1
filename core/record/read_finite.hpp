// SPDX-License-Identifier: GPL-2.0-or-later
// Reading of checkpoints: refuses numbers that are not finite.
#pragma once
#include <cstdint>
#include <string>

#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// What is wrong in an assembly, such as "the velocity of grain 3 is not finite": a number of a grain or of a contact
/// that is not finite, a radius that is not positive, or a cell without volume. Empty if nothing is wrong.
std::string flaw_of(const Assembly& assembly);

/// As read_assembly. Throws CorruptFileError also for an assembly with a flaw (see flaw_of).
Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name);

/// Reads a number from an attribute. Throws CorruptFileError if a double is not finite or if an integer is negative.
struct ReadNumber {
  const hdf5::Group& group;
  void operator()(const char* name, double& value) const;
  void operator()(const char* name, std::int64_t& value) const;
};

}  // namespace flowslide
