// SPDX-License-Identifier: GPL-2.0-or-later
// Runs of the program `restartable` as processes that receive signals, and the files that they leave.
#pragma once
#include <chrono>
#include <string>
#include <thread>

#include "program/slide_case_text.hpp"
#include "record/checkpoint_store.hpp"
#include "record/result_file.hpp"
#include "record/same_bits.hpp"
#include "support/messages.hpp"
#include "support/process.hpp"

namespace flowslide {

/// A case in a scratch folder, and runs of it.
class ProgramTest : public testing::Test {
 protected:
  ProgramTest() {
    std::string text =
        slide_case_text();  // its small sample jams in slides that go on for long: a step that bears that
    for (std::size_t at = 0; (at = text.find("time_step = \"1e-5 s\"")) != std::string::npos;)
      text.replace(at, std::string("time_step = \"1e-5 s\"").size(), "time_step = \"5e-6 s\"");
    scratch_.write("case.toml", text + R"([point.alone]
figures = "12"
sample = "loose"
shear_rate = "5 1/s"
final_strain = 0.5
[shear_test]
rows = 300
[scale.quick]
replicates = 1
rows.row_interval = "5 ms"
rows.row_strain = 0.01
rows.most_rows = 400
stop.end_time = "0.2 s"
coupling.initial_velocity = "0.5 m/s"
point.RD.profile_strains = [0.05, 0.2]
)");
    scratch_.write("claims.toml", "");
    ::setenv("RESTARTABLE_CASE", scratch_.path().c_str(), 1);
    ::setenv("FLOWSLIDE_CACHE", cache().c_str(), 1);
  }
  /// Samples are the same for all tests: prepared once.
  static std::filesystem::path cache() { return std::filesystem::path(RESTARTABLE_CACHE); }
  std::filesystem::path out(const std::string& name) const { return scratch_.path() / name; }

  Words command(const std::string& folder, const Words& options) const {
    Words words{RESTARTABLE_PROGRAM, "--output", out(folder).string(), "--checkpoint-interval", "10 ms"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }
  int run(const std::string& folder, const Words& options, const std::function<void()>& prepare = {}) {
    Process process(command(folder, options), scratch_.path() / "said", prepare);
    const int code = process.wait();
    said_ = process.said();
    return code;
  }
  int run_for(double seconds, const std::string& folder, Words options) {
    options.insert(options.end(), {"--max-walltime", std::to_string(seconds) + " s"});
    return run(folder, options);
  }
  /// Starts a run and waits until it has kept a checkpoint.
  std::unique_ptr<Process> start(const std::string& folder, const std::string& point, const Words& options) {
    const CheckpointStore store(out(folder) / ".flowslide", point);
    const auto before = store.last_write();
    auto process = std::make_unique<Process>(command(folder, options), scratch_.path() / (folder + ".said"));
    for (int i = 0; i < 6000 && store.last_write() == before && process->runs(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    return process;
  }
  /// All that is data in the files of a point; provenance has times.
  void expect_same_files(const std::string& point, const std::string& folder, const std::string& expected) const {
    const Result a = read_result(out(folder) / (point + ".h5")), b = read_result(out(expected) / (point + ".h5"));
    expect_same_bits(a.series, b.series);
    EXPECT_EQ(a.configuration, b.configuration);
    ASSERT_EQ(a.metrics.size(), b.metrics.size());
    for (std::size_t i = 0; i < a.metrics.size(); ++i) EXPECT_EQ(a.metrics[i].value, b.metrics[i].value) << i;
    for (const char* end : {".dat", "_profiles.dat"}) {
      const auto file = out(folder) / (point + end), other = out(expected) / (point + end);
      ASSERT_EQ(std::filesystem::exists(file), std::filesystem::exists(other)) << end;
      EXPECT_EQ(content_of(file), content_of(other)) << end;
    }
  }
  Provenance provenance_of(const std::string& folder, const std::string& point) const {
    return read_result(out(folder) / (point + ".h5")).provenance;
  }
  /// Expects no checkpoints and no half-written files.
  void expect_nothing_left(const std::string& folder) const {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(out(folder))) {
      const std::string name = entry.path().filename().string();
      if (name.starts_with(".case.")) continue;  // the mark of the folder, by whom made it: that belongs to no point
      EXPECT_FALSE(name.ends_with(".partial") || name.find("checkpoint") != std::string::npos) << name;
    }
  }

  ScratchFolder scratch_;
  std::string said_;
};

}  // namespace flowslide
