// SPDX-License-Identifier: GPL-2.0-or-later
// Reading what a run goes on from: numbers that are not finite are refused.
#pragma once
#include <cstdint>
#include <string>

#include "grains/assembly.hpp"
#include "record/hdf5.hpp"

namespace flowslide {

/// What is wrong in an assembly, such as "the velocity of grain 3 is not finite": a number of a grain or of a contact
/// that is not finite, a radius that is not positive, or a cell without volume. Empty if nothing is.
std::string flaw_of(const Assembly& assembly);

/// read_assembly, and CorruptFileError for an assembly with a flaw.
Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name);

/// Reads a number that is an attribute: finite, and not negative where it is whole, or CorruptFileError.
struct ReadNumber {
  const hdf5::Group& group;
  void operator()(const char* name, double& value) const;
  void operator()(const char* name, std::int64_t& value) const;
};

}  // namespace flowslide
