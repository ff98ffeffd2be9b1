// SPDX-License-Identifier: GPL-2.0-or-later
// Bytes altered at 200 random places of each kind of file: found every time, and no number is read from them.
#include <random>

#include "record/checkpoint_store.hpp"
#include "record/damage.hpp"
#include "record/sample_store.hpp"
#include "restart/program.hpp"
#include "run/example_checkpoint.hpp"
#include "run/run_identity.hpp"

namespace flowslide {
namespace {

/// `whole` with one to eight bytes altered, all from one place on.
std::string corrupted(const std::string& whole, std::mt19937_64& random) {
  std::string bytes = whole;
  const std::size_t place = random() % bytes.size(), count = 1 + random() % 8;
  for (std::size_t i = place; i < std::min(place + count, bytes.size()); ++i)
    bytes[i] = static_cast<char>(bytes[i] ^ static_cast<char>(1 + random() % 255));
  return bytes;
}

template <typename Read>
void expect_each_found(const std::filesystem::path& path, Read&& read) {
  const std::string whole = read_file(path);
  std::mt19937_64 random(200);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    overwrite(path, corrupted(whole, random));
    found += read() ? 0 : 1;
  }
  EXPECT_EQ(found, 200);
  overwrite(path, whole);
  EXPECT_TRUE(read());
}

TEST(Corruption, OfACheckpoint) {
  const ScratchFolder scratch;
  CheckpointStore store(scratch.path(), "RD");
  for (int number = 1; number <= 2; ++number)
    store.put([&](hdf5::Group& root) {
      Checkpoint checkpoint = example_checkpoint();
      checkpoint.share_done = number;
      write_checkpoint(root, checkpoint);
    });
  // The newest is used, or else the one before with all its numbers.
  expect_each_found(store.path(0), [&] {
    Checkpoint read;
    store.read_newest([&](const hdf5::Group& root) { read = read_checkpoint(root); }, [](std::string_view) {});
    expect_same_bits(*read.sample.grains, *example_checkpoint().sample.grains);
    return read.share_done == 2.0;
  });
}

TEST(Corruption, OfACachedSample) {
  const ScratchFolder scratch;
  const SampleStore store(scratch.path());
  store.put("abc", {"recipe", example_assembly(), {{"void_ratio", 0.79, "1", "void ratio"}}});
  expect_each_found(store.path("abc"), [&] {
    try {
      return store.find("abc").has_value();
    } catch (const CorruptFileError&) {
      return false;
    }
  });
}

TEST(Corruption, OfAResult) {
  const ScratchFolder scratch;
  const auto path = scratch.path() / "RD.h5";
  write_result(path, example_result());
  expect_each_found(path,
                    [&] { return find_result(path, RunIdentity(example_result())).standing == Standing::complete; });
}

/// With whole programs: a damaged result is not plotted or evaluated, and a damaged sample is not sheared.
class CorruptionProgram : public ProgramTest {};

TEST_F(CorruptionProgram, RefusesWhatIsDamaged) {
  const Words options{"--point", "RI"};
  ASSERT_EQ(run("out", options), 0) << said_;
  const auto result = out("out") / "RI.h5";
  const std::string whole = read_file(result);
  std::mt19937_64 random(5);
  for (int i = 0; i < 5; ++i) {
    overwrite(result, corrupted(whole, random));
    EXPECT_EQ(run("out", {"--point", "RI", "--check"}), 2) << said_;
    EXPECT_CONTAINS(said_, "delete it and execute that run again");
    EXPECT_EQ(run("out", options), 2) << said_;
    EXPECT_CONTAINS(said_, "or begin it anew with --afresh");
  }
}

TEST_F(CorruptionProgram, ShearsNoDamagedSample) {
  const Words options{"--engine", "native", "--point", "alone"};
  ::setenv("FLOWSLIDE_CACHE", out("cache").c_str(), 1);
  ASSERT_EQ(run("out", options), 0) << said_;
  std::filesystem::path sample;
  for (const auto& entry : std::filesystem::directory_iterator(out("cache")))
    if (entry.path().extension() == ".h5") sample = entry.path();
  const std::string whole = read_file(sample);
  std::mt19937_64 random(7);
  for (int i = 0; i < 5; ++i) {
    overwrite(sample, corrupted(whole, random));
    EXPECT_EQ(run("other", options), 2) << said_;
    EXPECT_CONTAINS(said_, "delete it, and the sample will be prepared again");
    EXPECT_FALSE(std::filesystem::exists(out("other") / "alone.h5"));
  }
}

TEST_F(CorruptionProgram, GoesOnWithNoSampleButItsOwn) {
  const Words options{"--engine", "native", "--point", "alone"};
  ::setenv("FLOWSLIDE_CACHE", out("cache").c_str(), 1);
  const auto process = start("out", "alone", options);
  process->signal(SIGTERM);
  ASSERT_EQ(process->wait(), 75) << process->said();
  // The sample has been prepared anew since, with another stress.
  const SampleStore store(out("cache"));
  for (const auto& entry : std::filesystem::directory_iterator(out("cache"))) {
    if (entry.path().extension() != ".h5") continue;
    const std::string key = entry.path().stem().string();
    StoredSample sample = *store.find(key);
    for (Vector3& position : sample.assembly.position) position.x() += 1e-4;
    for (Vector3& force : sample.assembly.force) force *= 1.001;
    store.put(key, sample);
  }
  EXPECT_EQ(run("out", options), 2) << said_;
  EXPECT_CONTAINS(said_, "the checkpoint of alone does not fit: the state is that of another sample");
  EXPECT_CONTAINS(said_, "begin this run anew with --afresh");
  EXPECT_EQ(run("out", {"--engine", "native", "--point", "alone", "--afresh"}), 0) << said_;
}

}  // namespace
}  // namespace flowslide
