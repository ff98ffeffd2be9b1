// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/sample_cache.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <thread>

#include "process/ranks.hpp"
#include "record/hash.hpp"
#include "record/sample_store.hpp"
#include "sample/failure.hpp"
#include "sample_library/sample_health.hpp"

namespace flowslide {
namespace {

/// Rough total for the progress line: a preparation takes 120 000 to 250 000 steps.
constexpr std::int64_t typical_steps = 200'000;

/// Pause between two attempts to lock a sample that another process prepares.
constexpr std::chrono::milliseconds time_between_tries{50};

double metric(const StoredSample& stored, const std::string& name) {
  if (const std::optional<double> value = value_of(stored.metrics, name)) return *value;
  throw CorruptFileError("has no '" + name + "': it is of another version; delete it, and it will be prepared again");
}

StoredSample stored(const PreparedSample& sample, const std::string& recipe) {
  const auto pascal = [](const char* name, double value, const char* text) { return Metric{name, value, "Pa", text}; };
  return {recipe,
          sample.assembly,
          {{"void_ratio", sample.void_ratio, "1", "void ratio of the cell"},
           {"probe_void_ratio", sample.probe_void_ratio, "1", "void ratio without the outer 7.5 % of the height"},
           {"kinetic_number", sample.kinetic_number, "1", "mean kinetic energy of a grain over p D^3"},
           {"steps", static_cast<double>(sample.steps), "1", "steps of the preparation"},
           pascal("normal_stress", sample.stress.normal, "normal stress at rest"),
           pascal("shear_stress", sample.stress.shear, "shear stress at rest"),
           pascal("transverse_stress", sample.stress.transverse, "transverse shear stress at rest"),
           pascal("lateral_stress_x", sample.stress.lateral_x, "lateral stress along x at rest"),
           pascal("lateral_stress_y", sample.stress.lateral_y, "lateral stress along y at rest")}};
}

PreparedSample prepared(const StoredSample& stored) {
  PreparedSample sample;
  sample.assembly = stored.assembly;
  sample.stress = {metric(stored, "normal_stress"), metric(stored, "shear_stress"),
                   metric(stored, "transverse_stress"), metric(stored, "lateral_stress_x"),
                   metric(stored, "lateral_stress_y")};
  sample.void_ratio = metric(stored, "void_ratio");
  sample.probe_void_ratio = metric(stored, "probe_void_ratio");
  sample.kinetic_number = metric(stored, "kinetic_number");
  sample.steps = static_cast<std::int64_t>(metric(stored, "steps"));
  return sample;
}

/// Returns the lock of a sample on the first rank, and an empty optional on the others. Waits until no other process
/// holds the lock; a message says so once.
std::optional<FileLock> wait_for(const SampleStore& store, const std::string& key, const std::string& label,
                                 const ProgressStyle& style, const PreparationPoll& poll) {
  std::optional<FileLock> lock;
  for (bool reported = false;; reported = true) {
    on_first_rank([&] {
      try {
        lock = store.try_lock(key);
      } catch (const FileError& error) {
        throw FileError(
            fmt::format("{}: it is not in the cache and cannot be prepared there: {}; set FLOWSLIDE_CACHE to "
                        "a folder that has it or may be written",
                        label, error.what()));
      }
      if (!lock && !reported)
        style.say(fmt::format("{}: waits for {}, which prepares this sample ({})", label, store.holder(key), key));
    });
    if (same_on_all_ranks(lock.has_value())) return lock;
    if (poll) poll([] { return false; });
    std::this_thread::sleep_for(time_between_tries);
  }
}

/// Makes the folder of the cache and reports it. If this fails, the store refuses the folder later.
void say_if_new(const std::filesystem::path& cache, const ProgressStyle& style) {
  std::error_code failure;
  if (!std::filesystem::create_directories(cache, failure) || style.silent) return;
  std::ostream& out = style.stream != nullptr ? *style.stream : std::cerr;
  out << fmt::format("flowslide: prepared samples are kept in {}, a new folder; set FLOWSLIDE_CACHE to use another\n",
                     std::filesystem::absolute(cache, failure).string());
}

/// The record of a failed preparation. Its text includes `most_steps`, because more steps may let the same recipe
/// succeed. The key of a sample leaves them out: they do not affect a completed sample.
FailedSample failed(const SampleRecipe& recipe, const std::string& reason) {
  return {fmt::format("{}most_steps = {}\n", recipe.text(), recipe.most_steps), reason};
}

/// Provides the sample of a recipe: from the cache, or by a preparation whose result is then stored in the cache.
struct SampleProvider {
  Engine& engine;
  const SampleStore& store;
  const std::filesystem::path& folder;
  const ProgressStyle& style;
  const PreparationPoll& poll;

  PreparedSample sample(const SampleRecipe& recipe, const std::string& label) const {
    const std::string key = cache_key(recipe, preparation_identity(engine.name(), engine.version()));
    // First without a lock: the cache may belong to another user or be read-only.
    if (auto kept = find(recipe, key)) return *std::move(kept);
    on_first_rank([&] { say_if_new(folder, style); });
    const std::optional<FileLock> lock = wait_for(store, key, label, style, poll);
    if (auto kept = find(recipe, key)) return *std::move(kept);
    PreparationCheckpoints checkpoints(folder, key);
    try {
      PreparedSample made = prepare(recipe, label, checkpoints);
      on_first_rank([&] { store.put(key, stored(made, recipe.text())); });
      checkpoints.remove();
      return made;
    } catch (const NumericalFailure& failure) {
      on_first_rank([&] { store.put_failure(key, failed(recipe, failure.what())); });
      checkpoints.remove();
      throw;
    }
  }

  /// Prepares the sample, from its last checkpoint if it has one. Shows progress and writes checkpoints.
  PreparedSample prepare(const SampleRecipe& recipe, const std::string& label,
                         PreparationCheckpoints& checkpoints) const {
    const std::optional<PreparationState> from = checkpoints.find();
    const std::int64_t done = from ? from->steps : 0;
    Progress progress(label, std::max(typical_steps, done), style, done);
    if (from) progress.message(fmt::format("{}: continues in {}", label, name_of_stage(from->stage)));
    const auto observe = [&](const PreparationProgress& now) {
      if (now.steps > typical_steps) progress.set_total(now.steps + typical_steps / 10);
      progress.update(now.steps, fmt::format("{}, e {:.3f}, sigma {:.0f} Pa", name_of_stage(now.stage), now.void_ratio,
                                             now.stress.normal));
      if (poll) poll([&] { return checkpoints.keep(now.state()); });
    };
    PreparedSample made = prepare_sample(engine, recipe, observe, from ? &*from : nullptr);
    progress.finish(fmt::format("e0 = {:.4f}, probe {:.4f}", made.void_ratio, made.probe_void_ratio));
    return made;
  }

  /// The sample if the cache has it. Throws NumericalFailure if its preparation is known to fail.
  std::optional<PreparedSample> find(const SampleRecipe& recipe, const std::string& key) const {
    bool is_there = false, has_failed = false;
    on_first_rank([&] {
      is_there = store.has(key);
      has_failed = !is_there && store.has_failure(key);
    });
    if (same_on_all_ranks(is_there)) {
      const std::optional<StoredSample> kept = store.find(key);
      if (!kept) throw FileError(fmt::format("{} was removed while it was read", store.path(key).string()));
      try {
        return prepared(*kept);
      } catch (const CorruptFileError& error) {
        throw CorruptFileError(store.path(key).string() + " " + error.what());
      }
    }
    if (!same_on_all_ranks(has_failed)) return std::nullopt;
    const std::optional<FailedSample> known = store.find_failure(key);
    if (known && known->recipe == failed(recipe, {}).recipe) throw NumericalFailure(known->reason);
    return std::nullopt;
  }
};

}  // namespace

std::vector<Metric> metrics_of(const FoundSample& found) {
  std::vector<Metric> metrics{
      {"initial_void_ratio", found.sample.void_ratio, "1", "void ratio of the cell before shear"},
      {"initial_probe_void_ratio", found.sample.probe_void_ratio, "1",
       "void ratio without the outer 7.5 % of the height at each end, before shear"},
      {"preparation_friction", found.recipe.preparation_friction, "1", "mu_1 of the sample"},
      {"preparation_restitution", found.recipe.preparation_restitution, "1", "restitution of stages 1 to 3"},
      {"preparation_drag", found.recipe.drag, "kg/s", "drag on each grain during preparation"},
      {"mixing_velocity", found.recipe.mixing_velocity, "m/s",
       found.recipe.mixing_velocity > 0.0 ? "of the grains before stage 1" : "lattice: not mixed before stage 1"},
      {"preparation_trials", static_cast<double>(found.trials), "1", "samples prepared for this one"}};
  for (Metric& metric : metrics_of(found.health)) metrics.push_back(std::move(metric));
  return metrics;
}

std::filesystem::path sample_cache_folder() {
  const char* folder = std::getenv("FLOWSLIDE_CACHE");
  return folder && *folder ? std::filesystem::path(folder) : std::filesystem::path("cache");
}

std::string preparation_identity(const std::string& engine, const std::string& version) {
  return fmt::format("{} {}, procedure {}", engine, version, preparation_version());
}

std::string cache_key(const SampleRecipe& recipe, const std::string& preparation) {
  return hash_of(recipe.text() + "preparation = " + preparation + "\n");
}

FoundSample find_sample(Engine& engine, const SampleSpecification& specification, const std::filesystem::path& cache,
                        const ProgressStyle& style, const PreparationPoll& poll) {
  const SampleStore store(cache);
  const SampleProvider provider{engine, store, cache, style, poll};
  FoundSample found;
  const auto provide = [&](const SampleRecipe& recipe, const std::string& label) {
    found.sample = provider.sample(recipe, label);
    ++found.trials;
    found.health = packing_health(found.sample.assembly, recipe);
    if (const std::string uneven = unevenness(found.health); !uneven.empty() && !specification.allow_uneven)
      throw NumericalFailure(fmt::format("sample {}, seed {}: {}", specification.name, recipe.packing.seed, uneven));
  };
  int trials = 0;
  const auto prepare = [&](const SampleRecipe& recipe) {
    const std::string label = fmt::format("sample {} (e0 {} wanted), trial {}", specification.name,
                                          specification.target.void_ratio, ++trials);
    try {
      provide(recipe, label);
    } catch (const NumericalFailure& failure) {
      style.say(fmt::format("{}: failed: {}", label, failure.what()));
      throw;
    }
    return specification.target.region == VoidRatioRegion::probe ? found.sample.probe_void_ratio
                                                                 : found.sample.void_ratio;
  };
  found.recipe = search_void_ratio(specification.recipe, specification.target, prepare).back().recipe;
  found.name = specification.name + " " +
               cache_key(found.recipe, preparation_identity(engine.name(), engine.version()));
  return found;
}

}  // namespace flowslide
