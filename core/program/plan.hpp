// SPDX-License-Identifier: GPL-2.0-or-later
// The parts of a plan (--dry-run) and of a sample report that all cases share.
#pragma once
#include <iosfwd>
#include <string>

#include "sample/specification.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

/// Name of a replicate. `replicate` counts from 0; the first has no number: "e0_790", "e0_790_r2".
std::string replicate_name(const std::string& point, int replicate);

/// Processor time of one grain for one step on one core, s, in a dense sample (docs/performance.md). 0 for closed-form
/// samples. Used for predictions only.
double seconds_per_grain_and_step(const std::string& engine);

/// Prints the sample with which the search starts, and the key of its first trial in the cache.
void print_sample_plan(std::ostream& out, const SampleSpecification& sample, const std::string& preparation_engine);

/// Prints the sample that was found, with its health. A second line says in what way it is uneven, if it is.
void print_found_sample(std::ostream& out, const SampleSpecification& wanted, const FoundSample& found);

/// Prints the setup commands of LIGGGHTS, with the box of the loose packing. Prints nothing for other engines. Throws
/// MissingEngine if this build does not have the engine.
void print_engine_plan(std::ostream& out, const SampleRecipe& recipe, const std::string& engine, double time_step);

}  // namespace flowslide
