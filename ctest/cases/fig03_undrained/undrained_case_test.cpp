// SPDX-License-Identifier: GPL-2.0-or-later
// The case as its users meet it: case.toml and claims.toml as they are, the whole program, its exit codes.
#include "undrained_case.hpp"

#include <nlohmann/json.hpp>
#include <stdlib.h>

#include <cstdlib>

#include "dem/make_engine.hpp"
#include "input/read_samples.hpp"
#include "program/case_program.hpp"
#include "record/result_file.hpp"
#include "run/run_identity.hpp"
#include "sample_library/sample_cache.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;
using Options = std::vector<std::string>;

struct Outcome {
  int code = -1;
  std::string output, error;
};

class UndrainedProgram : public testing::Test {
 protected:
  UndrainedProgram() {
    ::setenv("FLOWSLIDE_CACHE", (scratch_.path() / "cache").c_str(), 1);
    fs::current_path(scratch_.path());
  }
  ~UndrainedProgram() override {
    ::unsetenv("FLOWSLIDE_CACHE");
    fs::current_path(before_);
  }

  Outcome run(const Options& options) const {
    std::vector<const char*> words{"fig03_undrained"};
    for (const std::string& option : options) words.push_back(option.c_str());
    UndrainedCase the_case;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = run_case(the_case, static_cast<int>(words.size()), words.data(), FLOWSLIDE_CASE_FOLDER);
    outcome.output = testing::internal::GetCapturedStdout();
    outcome.error = testing::internal::GetCapturedStderr();
    return outcome;
  }
  /// The message about bad input. Expects exit code 2, one message on stderr and no other output.
  std::string complaint(const Options& options) const {
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.code, 2) << outcome.error;
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(outcome.error.starts_with("flowslide: ")) << outcome.error;
    EXPECT_FALSE(fs::exists("results") || fs::exists("cache"));
    return outcome.error;
  }
  std::string complaint_about(const std::string& setting) const { return complaint({"--set", setting}); }

  ScratchFolder scratch_;
  fs::path before_ = fs::current_path();
};

TEST_F(UndrainedProgram, ListsItsPointsAndWritesNothing) {
  const Outcome list = run({"--list"});
  EXPECT_EQ(list.code, 0) << list.error;
  for (const char* name : {"e0_790", "e0_771", "e0_765", "e0_751", "I_1e-4", "I_2e-2"})
    EXPECT_CONTAINS(list.output, "\n" + std::string(name) + "\t");
  EXPECT_EQ(std::count(list.output.begin(), list.output.end(), '\n'), 1 + 3 * 6);  // three replicates at quick scale
  const auto point = nlohmann::json::parse(run({"--list", "--json", "--scale", "paper", "--point", "e0_790"}).output)
                         .at("points")
                         .at(0);
  EXPECT_EQ(point.at("name"), "e0_790");
  EXPECT_EQ(point.at("figures"), nlohmann::json::array({"2", "3"}));
  EXPECT_GT(point.at("predicted_seconds"), 0.0);
  EXPECT_EQ(point.at("description"), "sample e0_790 (seed 1) alone, 0.06 /s to 50 %");
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(UndrainedProgram, HasPointsForEveryReplicate) {
  const std::string list = run({"--list", "--replicates", "4"}).output;
  EXPECT_EQ(std::count(list.begin(), list.end(), '\n'), 1 + 4 * 6);
  EXPECT_CONTAINS(list, "\ne0_790_r4\t");
}

TEST_F(UndrainedProgram, PlansAndWritesNothing) {
  const Outcome plan =
      run({"--dry-run", "--point", "e0_790", "--set", "point.e0_790.shear_rate=0.25 1/s", "--set",
           "coupling.local_time_step=1e-5 s", "--set", "shear_test.rows=100", "--seed", "5"});
  EXPECT_EQ(plan.code, 0) << plan.error;
  EXPECT_CONTAINS(plan.output, "point.e0_790.shear_rate = \"0.25 1/s\" ");
  EXPECT_CONTAINS(plan.output, "seed 5\n");
  EXPECT_CONTAINS(plan.output, "# 200000 steps of 1e-05 s, 101 rows\n");  // 0.5 / (0.25 x 1e-5)
  EXPECT_CONTAINS_NOT(plan.output, "# run e0_771");
  EXPECT_TRUE(fs::is_empty(scratch_.path()));
}

TEST_F(UndrainedProgram, PlansTheCommandsOfLiggghts) {
  EXPECT_CONTAINS(run({"--dry-run", "--point", "e0_790", "--engine", "liggghts"}).output, "pair_style");
}

TEST_F(UndrainedProgram, PlansWithTheKeyThatTheCacheUses) {
  const auto setting = FLOWSLIDE_CASE_FOLDER "/case.toml";
  const Configuration configuration({setting, "quick", {}, {}});
  const auto samples = read_samples(configuration, read_slope(configuration), 0);
  const auto engine = make_engine("native", "/dev/null");
  const std::string key = cache_key(samples.at(0).recipe, preparation_identity(engine->name(), engine->version()));
  EXPECT_CONTAINS(run({"--dry-run", "--point", "e0_790"}).output, "first trial in the cache: " + key + "\n");
}

TEST_F(UndrainedProgram, RefusesSizesThatNothingHas) {
  EXPECT_CONTAINS(complaint_about("packing.lattice=[10, 10, 2]"), "it must be between 3 and");
  EXPECT_CONTAINS(complaint_about("packing.lattice=[0, 10, 10]"), "it must be between 3 and");
  EXPECT_CONTAINS(complaint_about("packing.lattice=[-10, 10, 10]"), "it must be between 3 and");
  EXPECT_CONTAINS(complaint_about("packing.lattice=[10, 10]"),
                  "the value has 2 values, but 3 are needed; give a list of three");
  EXPECT_EQ(complaint_about("packing.smallest_diameter=0 mm"),
            "flowslide: --set packing.smallest_diameter=0 mm: the value is not allowed: it must be above 0 m; give "
            "another\n");
  EXPECT_CONTAINS(complaint_about("packing.smallest_diameter=-5 mm"), "it must be above 0 m");
  EXPECT_CONTAINS(complaint_about("packing.largest_diameter=4 mm"),
                  "the value is below packing.smallest_diameter, 0.005 m; change one of them");
  EXPECT_CONTAINS(complaint_about("slope.thickness=-2 m"), "it must be above 0 m");
  EXPECT_CONTAINS(complaint_about("slope.water_table=3 m"), "water table is 3; allowed: 0 to 2");
}

TEST_F(UndrainedProgram, RefusesTimeStepsAbove065RayleighTimes) {
  // 0.65 x pi R sqrt(rho / G) / (0.1631 nu + 0.8766) = 1.013e-5 s for R = 2.5 mm and Table 1.
  for (const std::string key : {"coupling.local_time_step", "preparation.time_step"}) {
    EXPECT_EQ(run({"--list", "--set", key + "=1.01e-5 s"}).code, 0);
    const std::string message = complaint_about(key + "=1.02e-5 s");
    EXPECT_CONTAINS(message, "--set " + key + "=1.02e-5 s: ");
    EXPECT_CONTAINS(message, "at most 1.01e-05 s, which is 0.65 of the Rayleigh time");
    EXPECT_CONTAINS(message, "choose a smaller step");
    EXPECT_CONTAINS(complaint_about(key + "=0 s"), "it must be above 0 s");
  }
}

TEST_F(UndrainedProgram, RefusesWhatCannotBeReached) {
  EXPECT_CONTAINS(complaint_about("sample.e0_790.void_ratio=0.3"), "it must be above 0.55 and below 1");
  EXPECT_CONTAINS(complaint_about("slope.angle=40 deg"), "but a sample with friction 0.5 bears less than 0.5");
  EXPECT_CONTAINS(complaint_about("point.e0_790.shear_rate=0 1/s"), "it must be above 0 1/s");
  const std::string for_ever = complaint_about("point.e0_790.shear_rate=1e-20 1/s");
  EXPECT_CONTAINS(for_ever, "a strain of 0.5 at the rate 1e-20 1/s");
  EXPECT_CONTAINS(for_ever, "shear faster");
  EXPECT_CONTAINS(complaint_about("point.e0_790.final_strain=0"), "it must be above 0 and at most 100");
  EXPECT_CONTAINS(complaint_about("point.e0_790.picture_strain=60 %"), "it must be between 0 and 0.5");
  EXPECT_CONTAINS(complaint_about("point.I_1e-4.inertial_number=-1e-4"), "it must be above 0");
  EXPECT_CONTAINS(complaint_about("shear_test.rows=5"), "it must be between 10 and 100000");
  EXPECT_CONTAINS(complaint({"--replicates", "0"}), "--replicates: \"0\" is not allowed");
}

TEST_F(UndrainedProgram, RefusesUnknownNamesWithTheNearest) {
  EXPECT_CONTAINS(complaint({"--engine", "ligghts"}), "did you mean \"liggghts\"?");
  EXPECT_CONTAINS(complaint_about("engine=ligghts"), "it must be \"liggghts\"");
  EXPECT_CONTAINS(complaint({"--point", "e0_79"}), "it must be \"e0_790\", \"e0_771\"");
  EXPECT_CONTAINS(complaint({"--point", "e0_79"}), "did you mean \"e0_790\"?");
  EXPECT_CONTAINS(complaint_about("point.e0_790.sample=e0_71"), "did you mean \"e0_771\"?");
  EXPECT_EQ(complaint_about("shear_test.row=5"),
            "flowslide: --set shear_test.row=5: unknown key \"shear_test.row\"; did you mean "
            "\"shear_test.rows\"?\n");
  const fs::path user = scratch_.write("user.toml", "[packing]\n  latice = [5, 5, 6]\n");
  EXPECT_EQ(complaint({"--config", user.string()}), "flowslide: " + user.string() +
                                                        ":2:3: unknown key \"packing.latice\"; did you mean "
                                                        "\"packing.lattice\"?\n");
}

TEST_F(UndrainedProgram, RefusesItsOldKeysWithTheNewNames) {
  EXPECT_EQ(complaint_about("shear.time_step=1e-5 s"),
            "flowslide: --set shear.time_step=1e-5 s: \"shear.time_step\" is called \"coupling.local_time_step\" now; "
            "rename it\n");
  EXPECT_CONTAINS(complaint_about("shear.rows=100"), "is called \"shear_test.rows\" now");
  // In a scale that was not chosen, too.
  const fs::path user = scratch_.write("user.toml", "[scale.paper]\npoint.e0_771.time_step = \"5e-6 s\"\n");
  EXPECT_CONTAINS(
      complaint({"--config", user.string()}),
      user.string() + ":2:14: \"point.e0_771.time_step\" is called \"point.e0_771.coupling.local_time_step\"");
}

TEST_F(UndrainedProgram, SaysThatAKeyOfSlidesHasNoUseHere) {
  EXPECT_EQ(
      complaint_about("stop.end_time=3 s"),
      "flowslide: --set stop.end_time=3 s: the table \"stop\" is known, but no run of this case uses it: it belongs "
      "to slides, which are runs with a scheme\n");
  EXPECT_CONTAINS(complaint_about("coupling.time_step=1e-4 s"), "the key \"coupling.time_step\" is known, but no run");
  EXPECT_CONTAINS(complaint({"--allow-unstable"}), "it belongs to slides, which are runs with a scheme");
}

TEST_F(UndrainedProgram, HasNoClosedFormSamples) {
  EXPECT_CONTAINS(complaint({"--engine", "elastic"}), "it must be \"liggghts\"");
}

TEST_F(UndrainedProgram, NamesThePlaceOfABadValue) {
  const fs::path user = scratch_.write("user.toml", "[sample.e0_790]\nvoid_ratio = 0.3\n");
  EXPECT_CONTAINS(complaint({"--config", user.string()}),
                  user.string() + ":2:14: sample.e0_790.void_ratio = 0.3 is not allowed: it must be above 0.55");
}

/// The curve at I = 2e-2 with a sample of 150 grains of any void ratio, to 1 % strain.
const Options small{"--set",    "packing.lattice=[5, 5, 6]",
                    "--set",    "preparation.compaction_rate=2 1/s",
                    "--set",    "preparation.stress_tolerance=5e-3",
                    "--set",    "sample.isotropic.tolerance=0.3",
                    "--set",    "point.I_2e-2.final_strain=1 %",
                    "--set",    "shear_test.rows=10",
                    "--set",    "point.I_2e-2.picture_strain=0.5 %",
                    "--point",  "I_2e-2",
                    "--output", "out"};

TEST_F(UndrainedProgram, RunsAPointOnceAndThenSkipsIt) {
  const Outcome first = run(small);
  ASSERT_EQ(first.code, 0) << first.error;
  const Result result = read_result("out/I_2e-2.h5");
  EXPECT_EQ(result.provenance.engine, "native");
  EXPECT_EQ(result.provenance.figure, "4");
  EXPECT_EQ(result.provenance.seed, 1);
  EXPECT_EQ(result.series.rows(), 11U);
  // To half a step: I = 2e-2 at sigma_0 is 10.9 1/s for grains of 6 mm, times 1e-5 s.
  EXPECT_NEAR(result.series.column("shear_strain").values.back(), 0.01, 6e-5);
  EXPECT_EQ(result.series.column("shear_strain").values.front(), 0.0);
  // The rate is chosen for I = 2e-2 at sigma_0; the mean stress of the bulk differs from that by some percent.
  EXPECT_NEAR(result.series.column("inertial_number").values.front(), 2e-2, 4e-3);
  for (const char* file : {"I_2e-2.dat", "I_2e-2.pvd", "fig02_before.dat", "fig02_during.dat"})
    EXPECT_TRUE(fs::exists(fs::path("out") / file)) << file;

  const std::string bytes = content_of("out/I_2e-2.h5");
  const Outcome again = run(small);
  EXPECT_EQ(again.code, 0);
  EXPECT_CONTAINS(again.error, "I_2e-2: the result exists, with this configuration (code ");
  EXPECT_EQ(content_of("out/I_2e-2.h5"), bytes);

  Options other = small;
  other.insert(other.end(), {"--set", "shear_test.rows=11"});
  const Outcome refused = run(other);
  EXPECT_EQ(refused.code, 2);
  EXPECT_CONTAINS(refused.error, "is the result of another run (shear_test.rows = 10 there, 11 now)");

  // These are not the settings of the paper: no claim about Fig. 4 is evaluated, of a point that was run or not.
  Options check = small;
  check.push_back("--check");
  const Outcome checked = run(check);
  EXPECT_EQ(checked.code, 0);
  EXPECT_CONTAINS(checked.output, "not the paper's settings: packing.lattice = [5, 5, 6], not [10, 10, 11]");
  EXPECT_CONTAINS(content_of("out/legend.txt"), "I_2e-2\t{/:Italic I} = 2×10^{−2}\n");

  // The sample that fitted is in the cache; a search that asks for more than it offers ends with it, and code 3.
  Options search = small;
  search.back() = "other";
  search.insert(search.end(), {"--set", "sample.isotropic.tolerance=1e-9", "--set", "sample.isotropic.most_trials=1"});
  const Outcome failed = run(search);
  EXPECT_EQ(failed.code, 3);
  EXPECT_CONTAINS(failed.error, "flowslide: no sample with the void ratio");
  EXPECT_CONTAINS(failed.error, "allow a wider tolerance or more trials");
  EXPECT_FALSE(fs::exists("other/I_2e-2.h5"));

  // A kept sample that is damaged is never used; the message says what to delete.
  fs::path kept;
  for (const auto& entry : fs::directory_iterator("cache"))
    if (entry.path().extension() == ".h5") kept = fs::absolute(entry.path());
  std::ofstream(kept, std::ios::binary | std::ios::app) << "x";
  const Outcome corrupt = run(search);
  EXPECT_EQ(corrupt.code, 2);
  EXPECT_CONTAINS(corrupt.error, "flowslide: " + kept.string());
  EXPECT_CONTAINS(corrupt.error, "delete it, and the sample will be prepared again");
}

}  // namespace
}  // namespace flowslide
