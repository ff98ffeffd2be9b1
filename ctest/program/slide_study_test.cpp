// SPDX-License-Identifier: GPL-2.0-or-later
// Changes that a study of a case may make, and changes that are refused: loadings, settings, names and replicates.
#include <nlohmann/json.hpp>

#include "program/slide_program.hpp"
#include "record/result_file.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

TEST_F(SlideProgram, RunsUnderAnyLoading) {
  const std::string table = scratch_.write("load.txt", "0 0\n0.1 3000\n").string();
  for (const std::string loading :
       {"{history = 'constant'}", "{history = 'rate', rate = '10 kPa/s'}", "{history = 'pulse'}"}) {
    fs::remove_all(output());
    EXPECT_EQ(run({"--set", "point.RD.loading=" + loading, "--set", "stop.end_time=0.05 s"}), 0) << loading << error_;
  }
  const auto file = scratch_.write("user.toml", "point.RD.loading = {history = 'table', file = '" + table + "'}\n");
  fs::remove_all(output());
  EXPECT_EQ(run({"--config", file.string(), "--set", "stop.end_time=0.05 s"}), 0) << error_;
}

TEST_F(SlideProgram, JudgesNoStudyWithOtherSettings) {
  const std::string changed = "loading.amplitude = \"2 kPa\", not \"3 kPa\"";
  ASSERT_EQ(run({"--set", "loading.amplitude=2 kPa"}), 0) << error_;
  EXPECT_CONTAINS(text_, "not evaluated  Fig. 12  all_there  > 0       2");  // measured, but not judged
  EXPECT_CONTAINS(text_, "not the paper's settings: " + changed);
  const auto claim = nlohmann::json::parse(content_of(output() / "claims.json")).at(0);
  EXPECT_EQ(claim.at("measured"), 2.0);
  EXPECT_TRUE(claim.at("met").is_null());
  EXPECT_EQ(content_of(output() / "changes.txt"), changed + "\n");
  ASSERT_EQ(run({"--list", "--set", "loading.amplitude=2 kPa"}), 0);
  EXPECT_CONTAINS(text_, "pulse of 2 kPa over 2 s");
  EXPECT_CONTAINS(error_, "settings differ from those of the case: " + changed + "; its claims are not evaluated");
  ASSERT_EQ(run({"--list", "--json", "--set", "loading.amplitude=2 kPa"}), 0);
  EXPECT_EQ(nlohmann::json::parse(text_).at("changed"), nlohmann::json::array({changed}));
}

TEST_F(SlideProgram, JudgesNoSampleWithoutGrains) {
  ASSERT_EQ(run({"--engine", "elastic"}), 0) << error_;
  EXPECT_CONTAINS(text_, "not evaluated  Fig. 12  all_there  > 0       2");
  EXPECT_CONTAINS(text_, "the claims are about samples of grains, and engine = \"elastic\" has no grains");
  const auto claim = nlohmann::json::parse(content_of(output() / "claims.json")).at(0);
  EXPECT_EQ(claim.at("measured"), 2.0);
  EXPECT_TRUE(claim.at("met").is_null());
  EXPECT_FALSE(fs::exists(output() / "changes.txt"));  // the settings are those of the case
}

TEST_F(SlideProgram, JudgesAStudyThatChoosesAnotherDraw) {
  ASSERT_EQ(run({"--engine", "native", "--seed", "8", "--replicates", "1", "--set", "rows.most_rows=20"}), 0) << error_;
  EXPECT_CONTAINS(text_, "met  Fig. 12");
  EXPECT_FALSE(fs::exists(output() / "changes.txt"));
}

TEST_F(SlideProgram, RefusesNamesThatMeet) {
  const auto refused = [&](const std::string& name) {
    const auto file = scratch_.write("user.toml", "[point." + name + "]\nlike = 'RD'\n");
    EXPECT_EQ(run({"--config", file.string()}), 2);
    EXPECT_FALSE(fs::exists(output()));
    return error_;
  };
  EXPECT_CONTAINS(refused("RD_r2"), "the name \"RD_r2\" is taken twice");
  EXPECT_CONTAINS(refused("RD_over_time"), "the name \"RD_over_time\" is taken twice");
  EXPECT_CONTAINS(refused("RI_profiles_band"), "a table of the figures");
  EXPECT_CONTAINS(refused("claims"), "by the program");
}

TEST_F(SlideProgram, RefusesReplicatesThatAreOneSample) {
  EXPECT_EQ(run({"--set", "sample.loose.seed_offsets=[5, 6, 5]"}), 2);
  EXPECT_CONTAINS(error_, "replicates 1 and 3 of the sample \"loose\" are the same");
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(SlideProgram, RefusesAReplicateWhoseSearchCameToTheSampleOfAnother) {
  const std::vector<std::string> options{"--engine", "native", "--point", "RD_r2", "--set", "stop.end_time=2e-3 s"};
  ASSERT_EQ(run(options), 0) << error_;
  Result other = read_result(output() / "RD_r2.h5");
  EXPECT_TRUE(other.provenance.sample.starts_with("loose ")) << other.provenance.sample;
  fs::remove(output() / "RD_r2.h5");
  other.provenance.replicate = 0;
  other.provenance.point = "RI";
  write_result(output() / "RI.h5", other);
  EXPECT_EQ(run(options), 2);
  EXPECT_CONTAINS(error_, "RI and RD_r2 are no replicates: they have the same sample \"loose\"");
  EXPECT_FALSE(fs::exists(output() / "RD_r2.h5"));
}

}  // namespace
}  // namespace flowslide
