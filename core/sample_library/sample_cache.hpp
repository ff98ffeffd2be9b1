// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "process/progress.hpp"
#include "record/series.hpp"
#include "sample/packing_health.hpp"
#include "sample/preparation.hpp"
#include "sample/specification.hpp"
#include "sample_library/preparation_checkpoints.hpp"

namespace flowslide {

/// A sample with the required void ratio, and how it was found.
struct FoundSample {
  PreparedSample sample;
  SampleRecipe recipe;    ///< recipe of the last trial, which is within the tolerance
  int trials = 0;         ///< number of trials that gave a sample
  PackingHealth health;
  std::string name = {};  ///< name of its table and a key of its recipe and engine: see Provenance::sample
};

/// Void ratios, recipe and health of a sample, as metrics of a result.
std::vector<Metric> metrics_of(const FoundSample& found);

/// Folder of the prepared samples: $FLOWSLIDE_CACHE, or `cache` in the current folder. If the folder is new,
/// find_sample makes it and reports its path.
std::filesystem::path sample_cache_folder();

/// Identity of what makes a sample from a recipe: engine, its version, and the hash of the preparation procedure.
std::string preparation_identity(const std::string& engine, const std::string& version);

/// Key of a recipe in the cache. `preparation` is a preparation_identity.
std::string cache_key(const SampleRecipe& recipe, const std::string& preparation);

/// Searches for a sample with the void ratio of the specification (see search_void_ratio). Caches every trial, failures
/// included, under a hash of recipe, engine and procedure. Repeating a search replays the same decisions without
/// running DEM. An uneven sample (see unevenness) counts as a failure unless the specification allows it. `poll` is
/// called at each checkpoint opportunity while a sample is prepared or waited for; the next call continues from the
/// checkpoint that `poll` keeps. Collective over the MPI ranks. Throws NumericalFailure if no trial fits,
/// CorruptFileError for a damaged file of the cache, and FileError for a cache that cannot be written.
FoundSample find_sample(Engine& engine, const SampleSpecification& specification, const std::filesystem::path& cache,
                        const ProgressStyle& style, const PreparationPoll& poll = {});

}  // namespace flowslide
