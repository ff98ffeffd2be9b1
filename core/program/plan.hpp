// SPDX-License-Identifier: GPL-2.0-or-later
// What the points of all cases say of themselves before they are run.
#pragma once
#include <iosfwd>
#include <string>

#include "sample/specification.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

/// Name of a point's replicate: replicates count from 0, and the first has no number, "e0_790", "e0_790_r2".
std::string replicate_name(const std::string& point, int replicate);

/// Time of a grain and step on one core, s, while the sample is dense (README, "Engines"). 0 for closed-form samples.
/// For predictions alone.
double seconds_per_grain_and_step(const std::string& engine);

/// The sample that a search starts with, and its key in the cache.
void print_sample_plan(std::ostream& out, const SampleSpecification& sample, const std::string& preparation_engine);

/// The sample that was found, with its health, and what is uneven in it.
void print_found_sample(std::ostream& out, const SampleSpecification& wanted, const FoundSample& found);

/// The commands by which `engine` would be set up, if it takes commands, for the box of the loose packing.
void print_engine_plan(std::ostream& out, const SampleRecipe& recipe, const std::string& engine, double time_step);

}  // namespace flowslide
