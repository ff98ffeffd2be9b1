// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_store.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "damage.hpp"
#include "example.hpp"
#include "full_disk.hpp"
#include "same_bits.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

StoredSample example_sample() {
  return {"mu_1 = 0.3\nseed = 7\n", example_assembly(), {{"void_ratio", 0.79, "1", "void ratio"}}};
}

TEST(SampleStore, GivesBackEveryBit) {
  const TemporaryFolder folder;
  const SampleStore store(folder / "deep" / "samples");
  EXPECT_FALSE(store.find("abc123"));
  store.put("abc123", example_sample());
  const auto found = store.find("abc123");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->recipe, example_sample().recipe);
  expect_same_bits(found->assembly, example_sample().assembly);
  ASSERT_EQ(found->metrics.size(), 1);
  EXPECT_EQ(found->metrics[0].value, 0.79);
  EXPECT_FALSE(store.find("abc124"));
}

/// The sample, prepared by `prepare` and kept if there is none, as two processes do that need the same one. Waits for
/// the lock.
StoredSample find_or_prepare(const SampleStore& store, const std::string& key,
                             const std::function<StoredSample()>& prepare) {
  if (auto sample = store.find(key)) return *std::move(sample);
  auto held = store.try_lock(key);
  while (!held) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    held = store.try_lock(key);
  }
  // Another process may have prepared it while this one waited.
  if (auto sample = store.find(key)) return *std::move(sample);
  auto sample = prepare();
  store.put(key, sample);
  return sample;
}

TEST(SampleStore, NeverUsesADamagedSample) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  store.put("abc123", example_sample());
  expect_damage_found(store.path("abc123"), [&] { store.find("abc123"); });
  auto bytes = read_file(store.path("abc123"));
  overwrite(store.path("abc123"), bytes.substr(0, 1000));
  try {
    find_or_prepare(store, "abc123", [] { return example_sample(); });
    FAIL();
  } catch (const CorruptFileError& error) {
    EXPECT_NE(std::string(error.what()).find("delete it"), std::string::npos) << error.what();
  }
}

TEST(SampleStore, NeverUsesTheSampleOfAnotherKey) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  store.put("abc123", example_sample());
  std::filesystem::rename(store.path("abc123"), store.path("abc124"));
  EXPECT_THROW(store.find("abc124"), CorruptFileError);
}

TEST(SampleStore, LeavesNothingAfterAnError) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  {
    const FullDisk full(2000);
    EXPECT_THROW(store.put("abc123", example_sample()), FileError);
  }
  auto sample = example_sample();
  sample.assembly.contacts[2].tangential_spring.y() = std::nan("");
  EXPECT_THROW(store.put("abc123", sample), std::invalid_argument);
  EXPECT_EQ(folder.entries(), 0);
  write_atomically(folder / "file", "x");
  const SampleStore below_a_file(folder / "file" / "samples");
  EXPECT_THROW(below_a_file.put("abc123", example_sample()), FileError);
  EXPECT_THROW(below_a_file.try_lock("abc123"), FileError);
}

TEST(SampleStore, KeepsWhyAPreparationFailed) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  EXPECT_FALSE(store.find_failure("abc123"));
  store.put_failure("abc123", {"mu_1 = 0.3\n", "stage 4: failed: grain 7 is lost"});
  const auto found = store.find_failure("abc123");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->recipe, "mu_1 = 0.3\n");
  EXPECT_EQ(found->reason, "stage 4: failed: grain 7 is lost");
  EXPECT_FALSE(store.find("abc123"));
  EXPECT_FALSE(store.find_failure("abc124"));
  expect_damage_found(store.failure_path("abc123"), [&] { store.find_failure("abc123"); });
  std::filesystem::rename(store.failure_path("abc123"), store.failure_path("abc124"));
  EXPECT_THROW(store.find_failure("abc124"), CorruptFileError);
}

TEST(SampleStore, IsReadWithoutBeingWritten) {
  const TemporaryFolder folder;
  const SampleStore none(folder / "none");
  EXPECT_FALSE(none.has("key1"));
  EXPECT_FALSE(none.has_failure("key1"));
  EXPECT_FALSE(none.find("key1"));
  EXPECT_FALSE(none.find_failure("key1"));
  EXPECT_EQ(folder.entries(), 0u);  // not even the folder is made
  const auto held = none.try_lock("key1");
  EXPECT_TRUE(std::filesystem::exists(folder / "none"));
  EXPECT_NE(none.holder("key1").find("process " + std::to_string(::getpid()) + " on "), std::string::npos);
}

TEST(SampleStore, TakesOnlyPlainKeys) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  for (const char* key : {"", "../abc", "a/b", "a.b", "a b"}) {
    EXPECT_THROW(store.find(key), std::invalid_argument) << key;
    EXPECT_THROW(store.put(key, example_sample()), std::invalid_argument) << key;
  }
}

TEST(SampleStore, KeepsNothingWhenPreparationFails) {
  const TemporaryFolder folder;
  const SampleStore store(folder.path());
  const auto fail = []() -> StoredSample { throw std::runtime_error("unreachable void ratio"); };
  EXPECT_THROW(find_or_prepare(store, "abc123", fail), std::runtime_error);
  EXPECT_FALSE(store.find("abc123"));
  EXPECT_EQ(find_or_prepare(store, "abc123", example_sample).recipe, example_sample().recipe);
}

TEST(SampleStore, TwoProcessesPrepareASampleOnce) {
  const TemporaryFolder folder;
  const SampleStore store(folder / "samples");
  const auto prepare = [&] {
    std::ofstream(folder / "prepared", std::ios::app) << 'x';
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    return example_sample();
  };
  std::vector<pid_t> children;
  for (int i = 0; i < 4; ++i) {
    children.push_back(::fork());
    ASSERT_GE(children.back(), 0);
    if (children.back() == 0) {
      const auto sample = find_or_prepare(store, "abc123", prepare);
      ::_exit(sample.assembly.size() == example_sample().assembly.size() ? 0 : 1);
    }
  }
  for (const pid_t child : children) {
    int status = -1;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(read_file(folder / "prepared"), "x");
}

}  // namespace
}  // namespace flowslide
