// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample_library/sample_cache.hpp"

#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <map>
#include <set>

#include "program/run_main.hpp"
#include "record/sample_store.hpp"
#include "sample/failure.hpp"
#include "support/elastic_block.hpp"
#include "support/messages.hpp"
#include "support/perturb.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

SampleSpecification specification(double void_ratio, double tolerance = 0.02, int most_trials = 10) {
  SampleSpecification wanted{"loose", {}, {void_ratio, tolerance, most_trials}, true};
  wanted.recipe.packing.counts = {3, 3, 4};
  wanted.recipe.time_step = 5e-6;  // the block squeezes its lattice more than a servo would
  return wanted;
}

/// mu_1 = 0.3 ends at 0.72 + 0.045 - 0.015 = 0.75 +- 0.01: within +- 0.02 at once.
const SampleSpecification easy = specification(0.75);

class SampleCache : public testing::Test {
 protected:
  FoundSample find(Engine& engine, const SampleSpecification& wanted = easy) const {
    ProgressStyle style;
    style.silent = true;
    return find_sample(engine, wanted, folder(), style);
  }
  fs::path folder() const { return scratch_.path() / "cache"; }
  /// The samples that are kept.
  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder()))
      if (entry.path().extension() == ".h5") found.push_back(entry.path());
    return found;
  }
  /// What a program says that ends as `find` does, and its exit code.
  std::pair<int, std::string> end(Engine& engine, const SampleSpecification& wanted = easy) const {
    testing::internal::CaptureStderr();
    const int code = run_main([&] {
      find(engine, wanted);
      return 0;
    });
    return {code, testing::internal::GetCapturedStderr()};
  }
  ScratchFolder scratch_;
};

TEST_F(SampleCache, PreparesASampleAndKeepsIt) {
  ElasticBlock engine;
  const FoundSample found = find(engine);
  EXPECT_EQ(engine.preparations(), 1);
  EXPECT_EQ(found.trials, 1);
  EXPECT_EQ(found.recipe.text(), easy.recipe.text());
  EXPECT_NEAR(found.sample.void_ratio, 0.75, 0.02);
  EXPECT_NEAR(found.sample.stress.normal, 28340.0, 4e-3 * 28340.0);  // four stress tolerances, as rest() allows
  EXPECT_EQ(found.sample.steps, engine.steps());
  ASSERT_EQ(files().size(), 1U);
  EXPECT_EQ(files()[0].stem(), cache_key(easy.recipe, preparation_identity("block", "1")));
}

TEST_F(SampleCache, SaysOnceWhereItIsWhenItIsNew) {
  ElasticBlock engine;
  std::ostringstream out;
  ProgressStyle style;
  style.stream = &out;
  find_sample(engine, easy, folder(), style);
  EXPECT_TRUE(out.str().starts_with("flowslide: prepared samples are kept in " + folder().string() +
                                    ", a new folder; set FLOWSLIDE_CACHE to use another\n"))
      << out.str();
  out.str("");
  find_sample(engine, easy, folder(), style);
  EXPECT_EQ(out.str(), "");
}

TEST_F(SampleCache, FindsItAgainWithoutAStep) {
  ElasticBlock first, second;
  const FoundSample made = find(first), found = find(second);
  EXPECT_EQ(second.preparations(), 0);
  EXPECT_EQ(second.steps(), 0);
  EXPECT_EQ(found.trials, made.trials);
  EXPECT_EQ(found.recipe.text(), made.recipe.text());
  // Bit for bit: what a run starts from must not depend on who prepared it.
  EXPECT_EQ(found.sample.void_ratio, made.sample.void_ratio);
  EXPECT_EQ(found.sample.probe_void_ratio, made.sample.probe_void_ratio);
  EXPECT_EQ(found.sample.kinetic_number, made.sample.kinetic_number);
  EXPECT_EQ(found.sample.steps, made.sample.steps);
  EXPECT_EQ(found.sample.stress.normal, made.sample.stress.normal);
  EXPECT_EQ(found.sample.stress.shear, made.sample.stress.shear);
  EXPECT_EQ(found.sample.stress.transverse, made.sample.stress.transverse);
  EXPECT_EQ(found.sample.stress.lateral_x, made.sample.stress.lateral_x);
  EXPECT_EQ(found.sample.stress.lateral_y, made.sample.stress.lateral_y);
  EXPECT_EQ(found.sample.assembly.position, made.sample.assembly.position);
  EXPECT_EQ(found.sample.assembly.role, made.sample.assembly.role);
  EXPECT_EQ(found.sample.assembly.cell.upper, made.sample.assembly.cell.upper);
}

TEST_F(SampleCache, KeepsEveryTrialOfASearch) {
  // 0.03 above the law at mu_1 = 0.3, about which packings scatter by 0.01: the first trial cannot fit.
  const SampleSpecification far = specification(0.78, 0.006, 30);
  ElasticBlock first, second;
  const FoundSample made = find(first, far);
  ASSERT_GT(made.trials, 1);
  EXPECT_NEAR(made.sample.void_ratio, 0.78, 0.006);
  EXPECT_GT(made.recipe.preparation_friction, 0.3);
  EXPECT_EQ(made.recipe.packing.seed, far.recipe.packing.seed + static_cast<std::uint64_t>(made.trials) - 1);
  EXPECT_EQ(first.preparations(), made.trials);
  EXPECT_EQ(files().size(), static_cast<std::size_t>(made.trials));

  const FoundSample found = find(second, far);
  EXPECT_EQ(second.steps(), 0);
  EXPECT_EQ(found.trials, made.trials);
  EXPECT_EQ(found.recipe.text(), made.recipe.text());
  EXPECT_EQ(found.sample.void_ratio, made.sample.void_ratio);
}

TEST_F(SampleCache, RemembersTrialsThatFailed) {
  ElasticBlock first("1", 2), second;
  const FoundSample made = find(first);
  EXPECT_EQ(first.preparations(), 3);
  EXPECT_EQ(made.trials, 1);
  EXPECT_EQ(made.recipe.packing.seed, easy.recipe.packing.seed + 2);
  const FoundSample found = find(second);  // this engine would not fail: the failure was kept
  EXPECT_EQ(second.steps(), 0);
  EXPECT_EQ(found.trials, made.trials);
  EXPECT_EQ(found.recipe.text(), made.recipe.text());
  EXPECT_EQ(found.sample.void_ratio, made.sample.void_ratio);
  EXPECT_EQ(found.sample.assembly.position, made.sample.assembly.position);
}

TEST_F(SampleCache, TriesAgainWithMoreSteps) {
  SampleSpecification brief = specification(0.75, 0.02, 1);
  brief.recipe.most_steps = 60;
  ElasticBlock engine;
  const auto [code, message] = end(engine, brief);
  EXPECT_EQ(code, 3);
  EXPECT_CONTAINS(message, "stage 1 of 4, after 90 steps: the void ratio did not fall to its target");
  EXPECT_EQ(end(engine, brief).second, message);
  EXPECT_EQ(engine.steps(), 90);
  find(engine);
  EXPECT_EQ(engine.preparations(), 2);
}

TEST_F(SampleCache, RefusesAnUnevenSampleUnlessItIsTaken) {
  // The block keeps the lattice that it was loaded with.
  SampleSpecification even = specification(0.75, 0.05, 2);
  even.recipe.packing.counts = {8, 8, 9};
  even.allow_uneven = false;
  ElasticBlock first, second;
  const auto [code, message] = end(first, even);
  EXPECT_EQ(code, 3);
  EXPECT_CONTAINS(message,
                  "sample loose, seed 2: the sample is not as even as a random packing of its size: there is an "
                  "order of the lattice along ");
  EXPECT_CONTAINS(message, "where 0.");
  EXPECT_CONTAINS(message, "preparation.allow_uneven");
  EXPECT_EQ(first.preparations(), 2);  // the next seed might have been even
  EXPECT_EQ(end(second, even).second, message);
  EXPECT_EQ(second.steps(), 0);  // its samples are kept all the same
  std::ostringstream lines;
  ProgressStyle style;
  style.stream = &lines;
  EXPECT_THROW(find_sample(second, even, folder(), style), NumericalFailure);
  for (const char* trial : {"trial 1: failed: sample loose, seed 1: the sample is not as even",
                            "trial 2: failed: sample loose, seed 2: the sample is not as even"})
    EXPECT_CONTAINS(lines.str(), trial);  // also of samples of the cache
  even.allow_uneven = true;
  EXPECT_EQ(find(second, even).trials, 1);
  EXPECT_EQ(second.steps(), 0);
}

TEST_F(SampleCache, TellsTheHealthOfASampleInItsMetrics) {
  ElasticBlock engine;
  std::map<std::string, double> metrics;
  for (const Metric& metric : metrics_of(find(engine))) {
    EXPECT_TRUE(metrics.emplace(metric.name, metric.value).second) << metric.name;
    EXPECT_TRUE(std::isfinite(metric.value)) << metric.name;
  }
  for (const char* name : {"initial_void_ratio", "mixing_velocity", "void_ratio_spread_x", "middle_order_z",
                           "rattler_share", "upper_half_shear_stress"})
    EXPECT_TRUE(metrics.contains(name)) << name;
  EXPECT_EQ(metrics.at("mixing_velocity"), 0.0);
  EXPECT_GT(metrics.at("middle_order_z"), 0.5);
}

TEST_F(SampleCache, PreparesAgainForAnotherEngine) {
  ElasticBlock one("1"), two("2");
  find(one);
  find(two);
  EXPECT_EQ(two.preparations(), 1);
  EXPECT_EQ(files().size(), 2U);
}

TEST_F(SampleCache, SaysHowNearItCameWhenASearchFails) {
  // The law ends below 0.82: no friction opens a void ratio of 0.95.
  const SampleSpecification impossible = specification(0.95, 0.002, 3);
  ElasticBlock first, second;
  const auto [code, message] = end(first, impossible);
  EXPECT_EQ(code, 3);
  EXPECT_CONTAINS(message, "flowslide: no sample with the void ratio 0.95 +- 0.002 in 3 trials; the nearest has 0.");
  EXPECT_CONTAINS(message, "A larger drag opens looser samples");
  EXPECT_EQ(first.preparations(), 3);
  EXPECT_EQ(end(second, impossible).second, message);  // from the cache: the same again, without a step
  EXPECT_EQ(second.steps(), 0);
}

TEST_F(SampleCache, RefusesATargetThatNoPackingHasBeforeAnyStep) {
  ElasticBlock engine;
  const std::string message = message_of<std::invalid_argument>([&] { find(engine, specification(0.3)); });
  EXPECT_CONTAINS(message, "the void ratio 0.3 cannot be reached: packings of spheres at rest lie between 0.55 and 1");
  EXPECT_EQ(engine.steps(), 0);
}

TEST_F(SampleCache, NeverUsesADamagedSample) {
  ElasticBlock engine, other;
  find(engine);
  const fs::path file = files().at(0);
  const std::string whole = content_of(file);
  std::string flipped = whole;
  flipped[flipped.size() / 2] ^= 1;
  for (const std::string& damaged : {flipped, whole.substr(0, whole.size() / 2), std::string()}) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << damaged;
    const auto [code, message] = end(other);
    EXPECT_EQ(code, 2);
    EXPECT_CONTAINS(message, "flowslide: " + file.string());
    EXPECT_CONTAINS(message, "delete it, and the sample will be prepared again");
    EXPECT_EQ(other.steps(), 0);
    EXPECT_EQ(content_of(file), damaged);  // left as it is, for the user to look at
  }
  fs::remove(file);
  EXPECT_EQ(end(other).first, 0);
  EXPECT_EQ(other.preparations(), 1);
}

TEST_F(SampleCache, NamesTheFileOfAnotherVersion) {
  const std::string key = cache_key(easy.recipe, preparation_identity("block", "1"));
  Assembly assembly;
  assembly.resize(1);
  assembly.radius[0] = 3e-3;
  assembly.cell.upper = Vector3(0.01, 0.01, 0.01);
  SampleStore(folder()).put(key, {"recipe", assembly, {{"void_ratio", 0.75, "1", "void ratio"}}});
  ElasticBlock engine;
  const auto [code, message] = end(engine);
  EXPECT_EQ(code, 2);
  EXPECT_CONTAINS(message, (folder() / (key + ".h5")).string());
  EXPECT_CONTAINS(message, "delete it");
}

TEST_F(SampleCache, RefusesAFolderThatCannotBe) {
  const fs::path file = scratch_.write("file", "text");
  ElasticBlock engine;
  const std::string message = message_of<FileError>([&] {
    ProgressStyle style;
    style.silent = true;
    find_sample(engine, easy, file / "cache", style);
  });
  EXPECT_CONTAINS(message, (file / "cache").string());
  EXPECT_EQ(engine.steps(), 0);
}

TEST_F(SampleCache, UsesACompleteSampleWhereNothingCanBeLocked) {
  ElasticBlock first, second;
  const FoundSample made = find(first);
  const fs::path lock = files().at(0).replace_extension(".lock");
  fs::remove(lock);
  fs::create_directory(lock);  // in the place of the lock: as good as a folder that cannot be written, also for root
  EXPECT_EQ(find(second).sample.assembly.position, made.sample.assembly.position);
  EXPECT_EQ(second.steps(), 0);
}

TEST_F(SampleCache, RemembersAFailureWhereNothingCanBeLocked) {
  SampleSpecification brief = specification(0.75, 0.02, 1);
  brief.recipe.most_steps = 60;
  ElasticBlock engine;
  const auto [code, message] = end(engine, brief);
  ASSERT_EQ(code, 3);
  const fs::path lock = folder() / (cache_key(brief.recipe, "block 1") + ".lock");
  fs::remove(lock);
  fs::create_directory(lock);
  EXPECT_EQ(end(engine, brief), std::pair(3, message));
}

TEST_F(SampleCache, ReadsTheFolderOfAnotherUser) {
  ElasticBlock first, second, third;
  const FoundSample made = find(first);
  for (const fs::path& path : {scratch_.path(), folder()}) fs::permissions(path, fs::perms(0555));
  const bool root = ::geteuid() == 0;
  ASSERT_TRUE(!root || ::seteuid(65534) == 0);
  const FoundSample found = find(second);
  const auto [code, message] = end(third, specification(0.78));
  ASSERT_TRUE(!root || ::seteuid(0) == 0);
  for (const fs::path& path : {scratch_.path(), folder()}) fs::permissions(path, fs::perms(0755));
  EXPECT_EQ(found.sample.assembly.position, made.sample.assembly.position);
  EXPECT_EQ(second.steps(), 0);
  // Another sample is not there, and cannot be kept: that is said before it is prepared.
  EXPECT_EQ(code, 2);
  EXPECT_CONTAINS(message, "it is not in the cache and cannot be prepared there: cannot create the lock");
  EXPECT_CONTAINS(message, "set FLOWSLIDE_CACHE to a folder that has it or may be written");
  EXPECT_EQ(third.steps(), 0);
}

TEST_F(SampleCache, SaysWhoItWaitsFor) {
  const std::string key = cache_key(easy.recipe, preparation_identity("block", "1"));
  int ready[2], done[2];
  ASSERT_EQ(::pipe(ready), 0);
  ASSERT_EQ(::pipe(done), 0);
  const pid_t other = ::fork();
  if (other == 0) {
    const auto held = SampleStore(folder()).try_lock(key);
    char byte = 'x';
    const bool told = ::write(ready[1], &byte, 1) == 1 && ::read(done[0], &byte, 1) == 1;
    ::_exit(told ? 0 : 1);
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  std::ostringstream lines;
  ProgressStyle style;
  style.stream = &lines;
  ElasticBlock engine;
  int borders = 0;
  find_sample(engine, easy, folder(), style, [&](const auto&) {
    if (++borders == 3) {
      EXPECT_EQ(::write(done[1], &byte, 1), 1);
    }
  });
  EXPECT_EQ(::waitpid(other, nullptr, 0), other);
  const std::string waits =
      "sample loose (e0 0.75 wanted), trial 1: waits for process " + std::to_string(other) + " on ";
  EXPECT_CONTAINS(lines.str(), waits);
  EXPECT_CONTAINS(lines.str(), "which prepares this sample (" + key + ")");
  EXPECT_EQ(lines.str().find(waits), lines.str().rfind(waits));  // once
  EXPECT_EQ(engine.preparations(), 1);                           // the other one has kept nothing
}

TEST_F(SampleCache, ShowsItsProgress) {
  ElasticBlock engine;
  std::ostringstream lines;
  ProgressStyle style;
  style.stream = &lines;
  find_sample(engine, easy, folder(), style);
  EXPECT_CONTAINS(lines.str(), "sample loose (e0 0.75 wanted), trial 1");
  EXPECT_CONTAINS(lines.str(), "e0 = 0.7");
}

TEST(CacheKey, IsOfThirtyTwoHexadecimalDigits) {
  const std::string key = cache_key(easy.recipe, preparation_identity("block", "1"));
  EXPECT_EQ(key.size(), 32U);
  EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
  EXPECT_EQ(cache_key(easy.recipe, preparation_identity("block", "1")), key);
}

TEST(CacheKey, DiffersByThePreparationAndByEveryPartOfTheRecipe) {
  std::set<std::string> keys{cache_key({}, "a"), cache_key({}, "b"), cache_key({}, "a 1")};
  ASSERT_EQ(keys.size(), 3U);
  for_each_perturbation(SampleRecipe{}, [&](const std::string& name, const auto& field, const SampleRecipe& changed) {
    EXPECT_EQ(keys.insert(cache_key(changed, "a")).second, field.effect == Effect::on_result) << name;
  });
}

TEST(SampleCacheFolder, IsToldByTheEnvironment) {
  ::setenv("FLOWSLIDE_CACHE", "/somewhere/else", 1);
  EXPECT_EQ(sample_cache_folder(), "/somewhere/else");
  ::setenv("FLOWSLIDE_CACHE", "", 1);
  EXPECT_EQ(sample_cache_folder(), "cache");
  ::unsetenv("FLOWSLIDE_CACHE");
  EXPECT_EQ(sample_cache_folder(), "cache");
}

}  // namespace
}  // namespace flowslide
