// SPDX-License-Identifier: GPL-2.0-or-later
// Each replicate needs a sample of its own. Two replicates on the same sample would count one result twice.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "configuration/configuration.hpp"
#include "record/provenance.hpp"
#include "sample/specification.hpp"

namespace flowslide {

/// Throws ConfigurationError if two replicates start the search for a sample with the same recipe. `samples[r]` are the
/// samples of replicate r (see read_samples). The message names the place of the sample in `configuration`.
void refuse_equal_recipes(const Configuration& configuration,
                          const std::vector<std::vector<SampleSpecification>>& samples);

/// Throws ConfigurationError if two results of different replicates use the same sample (see Provenance::sample). This
/// may happen, because a search for a void ratio increases the seed and may reach a seed of another replicate. Seeds
/// that overlap are not refused earlier, because most searches end after a few seeds.
void refuse_equal_samples(const std::vector<Provenance>& results);

/// The same check before a run starts: compares `own` with the results of the other `points` of this configuration in
/// `folder`. Results that cannot be read are skipped; the functions that need them report the error.
void refuse_sample_of_others(const Provenance& own, const std::string& configuration_hash,
                             const std::filesystem::path& folder, const std::vector<std::string>& points);

}  // namespace flowslide
