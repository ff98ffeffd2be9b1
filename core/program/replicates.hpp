// SPDX-License-Identifier: GPL-2.0-or-later
// Replicates are runs on samples of their own. Two that have the same sample would count one result twice.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "record/provenance.hpp"
#include "sample/specification.hpp"

namespace flowslide {

/// Refuses two replicates that begin with the same recipe. `samples` are those of each replicate (see read_samples).
/// Throws ConfigurationError.
void refuse_equal_recipes(const std::vector<std::vector<SampleSpecification>>& samples);

/// Refuses two results of different replicates on one sample (see Provenance::sample). A search for a void ratio counts
/// seeds on, so that it may come to the sample of another replicate; ranges of seeds that overlap are allowed, as
/// searches end early. Throws ConfigurationError.
void refuse_equal_samples(const std::vector<Provenance>& results);

/// The same before a run is spent on it: `own` against the results of the other `points` of this configuration in a
/// folder. A result that cannot be read is left to whoever needs it.
void refuse_sample_of_others(const Provenance& own, const std::string& configuration_hash,
                             const std::filesystem::path& folder, const std::vector<std::string>& points);

}  // namespace flowslide
