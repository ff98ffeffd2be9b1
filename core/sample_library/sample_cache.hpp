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

/// A sample of the void ratio that was asked for, and how it was found.
struct FoundSample {
  PreparedSample sample;
  SampleRecipe recipe;    ///< of the last trial, the one that fits
  int trials = 0;
  PackingHealth health;
  std::string name = {};  ///< that of its table and its key in the cache: see Provenance::sample
};

/// Void ratios, recipe and health of a sample, as numbers of a result.
std::vector<Metric> metrics_of(const FoundSample& found);

/// Folder of the prepared samples: $FLOWSLIDE_CACHE, or `cache` below the current folder. find_sample says where it is
/// when it makes it.
std::filesystem::path sample_cache_folder();

/// What makes a sample from its recipe: an engine of that version, and the procedure of the preparation.
std::string preparation_identity(const std::string& engine, const std::string& version);

/// Key of a recipe in the cache; `preparation` is a preparation_identity.
std::string cache_key(const SampleRecipe& recipe, const std::string& preparation);

/// Searches the recipe until the sample has its void ratio. Every trial is kept in the cache under the hash of all that
/// went into it, engine included, one that failed with its reason, so that the same search takes the same way again
/// without a step. A sample that is uneven (see unevenness) counts as one that failed, unless the specification takes
/// it. Collective over the MPI ranks. Throws NumericalFailure, and CorruptFileError for a damaged file of the cache.
/// `border` is called many times while a sample is prepared or waited for: what it keeps of a preparation, the next
/// call goes on from.
FoundSample find_sample(Engine& engine, const SampleSpecification& specification, const std::filesystem::path& cache,
                        const ProgressStyle& style, const PreparationBorder& border = {});

}  // namespace flowslide
