// SPDX-License-Identifier: GPL-2.0-or-later
// A study as a whole program, on closed-form samples.
#include "study_case.hpp"

#include <nlohmann/json.hpp>

#include <set>

#include "experiment/ensemble.hpp"
#include "program/case_program.hpp"
#include "record/gnuplot_table.hpp"
#include "record/result_file.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr const char* short_run = "engine = 'critical_state'\n[stop]\nend_time = '0.3 s'\n";

class StudyProgram : public testing::Test {
 protected:
  int run(const std::string& text, std::vector<std::string> options = {}) {
    const auto file = scratch_.write("mine.toml", short_run + text).string();
    options.insert(options.end(), {"--config", file, "--output", output().string()});
    std::vector<const char*> words{"study"};
    for (const std::string& option : options) words.push_back(option.c_str());
    StudyCase study;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int code = run_case(study, static_cast<int>(words.size()), words.data(), FLOWSLIDE_CASE_FOLDER);
    text_ = testing::internal::GetCapturedStdout();
    error_ = testing::internal::GetCapturedStderr();
    return code;
  }
  fs::path output() const { return scratch_.path() / "out"; }
  Result result(const std::string& run) const { return read_result(output() / (run + ".h5")); }
  std::set<std::string> runs() const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(output()))
      if (entry.path().extension() == ".h5") names.insert(entry.path().stem().string());
    return names;
  }

  ScratchFolder scratch_;
  std::string text_, error_;
};

const std::string angles = "[sweep]\nangle = ['3 deg', '4 deg']\n";

TEST_F(StudyProgram, RunsEachValueByEachScheme) {
  ASSERT_EQ(run("[study]\nscheme = ['RD', 'RI']\n" + angles), 0) << error_;
  EXPECT_EQ(runs(), (std::set<std::string>{"RD_3deg", "RD_4deg", "RI_3deg", "RI_4deg"}));
  // tau_0 = m g sin(angle): the loading and the sample follow the swept slope.
  for (const auto& [name, degrees] : {std::pair{"RD_3deg", 3.0}, {"RI_4deg", 4.0}}) {
    const double angle = degrees * 0.017453292519943295;
    EXPECT_DOUBLE_EQ(parameter_of({result(name)}, "angle"), angle);
    EXPECT_DOUBLE_EQ(parameter_of({result(name)}, "swept_angle"), angle);
    EXPECT_NEAR(result(name).series.column("shear_stress").values.front(), 3100.0 * 9.81 * std::sin(angle), 1.0);
  }
  const Series sweep = read_table(output() / "sweep.dat").series;
  EXPECT_EQ(sweep.column("as_written").values, (std::vector<double>{3.0, 4.0}));
  EXPECT_EQ(sweep.column("RD_peak_shear_stress_median").values.back(),
            metric_of(result("RD_4deg"), "peak_shear_stress"));
  EXPECT_LT(sweep.column("RI_peak_shear_stress_median").values.front(), 1e5);
  EXPECT_CONTAINS(content_of(output() / "slides.dat"), "RI_4deg RI 4 1\n");
  EXPECT_CONTAINS(content_of(output() / "legend.txt"), "x axis\tangle (deg)\n");
  EXPECT_FALSE(fs::exists(output() / "changes.txt"));  // there are no settings of the paper to differ from
}

TEST_F(StudyProgram, KeepsResultsWhenAValueIsAdded) {
  ASSERT_EQ(run(angles), 0) << error_;
  const std::string before = content_of(output() / "RD_3deg.h5");
  ASSERT_EQ(run("[sweep]\nangle = ['3 deg', '4 deg', '4.5 deg']\n", {"--replicates", "2"}), 0) << error_;
  EXPECT_CONTAINS(error_, "RD_3deg: the result exists");
  EXPECT_EQ(content_of(output() / "RD_3deg.h5"), before);
  EXPECT_TRUE(runs().contains("RD_4p5deg_r2"));
  EXPECT_EQ(run("[slope]\nthickness = '3 m'\n" + angles), 2);
  EXPECT_CONTAINS(error_, "slope.thickness = \"2.0 m\" there, \"3.0 m\" now");
}

TEST_F(StudyProgram, RunsWithoutASweep) {
  ASSERT_EQ(run(""), 0) << error_;
  EXPECT_EQ(runs(), std::set<std::string>{"RD"});
  EXPECT_EQ(read_table(output() / "sweep.dat").series.rows(), 0U);
  EXPECT_CONTAINS(content_of(output() / "legend.txt"),
                  "note\tcritical\\_state, no grains; 1 sample per run; scale quick\n");
}

TEST_F(StudyProgram, SweepsTheSampleLoadingAndCoupling) {
  for (const auto& [sweep, name, parameter, value] :
       {std::tuple{"critical_state.void_ratio = [0.7, 0.8]", "RD_0p8", "swept_void_ratio", 0.8},
        {"amplitude = ['1 kPa', '2 kPa']", "RD_2kPa", "amplitude", 2000.0},
        {"coupling.time_step = ['1e-4 s', '5e-5 s']", "RD_5e-5s", "time_step", 5e-5},
        {"hydraulic_conductivity = ['0 m/s', '1e-4 m/s']", "RD_1e-4m_s", "hydraulic_conductivity", 1e-4}}) {
    fs::remove_all(output());
    ASSERT_EQ(run(std::string("[sweep]\n") + sweep + "\n"), 0) << error_;
    EXPECT_EQ(runs().size(), 2U) << sweep;
    EXPECT_DOUBLE_EQ(parameter_of({result(name)}, parameter), value) << sweep;
  }
  const Result low = result("RD_0m_s"), high = result("RD_1e-4m_s");
  EXPECT_NE(low.series.last("pore_pressure"), high.series.last("pore_pressure"));
}

TEST_F(StudyProgram, RefusesWhatCannotBeSwept) {
  const auto refused = [&](const std::string& text) {
    EXPECT_EQ(run(text), 2) << text;
    EXPECT_FALSE(fs::exists(output()));
    return error_;
  };
  EXPECT_CONTAINS(refused("[sweep]\nangel = ['3 deg']\n"),
                  "did you mean \"angle\"? allowed: a key with one value of [slope]");
  EXPECT_CONTAINS(refused("[sweep]\nangle = ['3 deg', '95 deg']\n"), "mine.toml:5:19: slope.angle = '95 deg'");
  EXPECT_CONTAINS(refused("[sweep]\nangle = ['3 deg', '4 kPa']\n"),
                  "mine.toml:5:19: slope.angle: \"4 kPa\" is a stress");
  const std::string both = refused("[slope]\nangle = '2 deg'\n" + angles);
  EXPECT_CONTAINS(both, "mine.toml:5:9: slope.angle = '2 deg' is fixed here, but it is also swept (");
  EXPECT_CONTAINS(both, "mine.toml:7:1: sweep.angle = ['3 deg', '4 deg']); remove \"slope.angle\" to sweep it, or "
                        "\"sweep.angle\" to keep it fixed");
  EXPECT_CONTAINS(refused("[scheme.RI]\nsmallest_rate = '2 1/s'\n[study]\nscheme = 'RI'\n[sweep]\nsmallest_rate = "
                          "['1 1/s']\n"),
                  "scheme.RI.smallest_rate = '2 1/s' is fixed here");
  EXPECT_CONTAINS(refused("[sweep]\nsmallest_rate = ['1 1/s']\n"), "has no effect: rate = \"global\" does not use it");
  EXPECT_CONTAINS(refused("[point.mine]\nsample = 'e0_790'\n"), "a study has no [point.mine]");
  EXPECT_CONTAINS(refused("[study]\nscheme = ['RD', 'RD']\n"), "gives \"RD\" twice");
  EXPECT_CONTAINS(refused("[study]\nscheme = 'fast'\n"), "it must be");
  EXPECT_CONTAINS(refused("[sweeps]\nangle = ['2 deg']\n"), "unknown table \"sweeps\"");
  EXPECT_CONTAINS(refused("[stop2]\n"), "unknown table \"stop2\"");
  EXPECT_EQ(run("[sweep]\nsample = ['e0_790', 'other']\n", {"--engine", "native"}), 2);
  EXPECT_CONTAINS(error_, "point.RD_other.sample = 'other' is not allowed: it must be \"e0_790\"");
  EXPECT_CONTAINS(refused("[slopes]\nangle = '2 deg'\n"), "unknown table \"slopes\"");
}

TEST_F(StudyProgram, SaysThatASweepChangedNoResult) {
  // Without a change of the load, the slope stands: nothing asks for the stiffness.
  ASSERT_EQ(run("[loading]\nhistory = 'constant'\n[sweep]\nelastic.shear_modulus = ['3 MPa', '6 MPa']\n",
                {"--engine", "elastic"}), 0) << error_;
  EXPECT_CONTAINS(error_, "sweep.elastic.shear_modulus has no effect: the runs of RD have the same result for all");
  fs::remove_all(output());
  ASSERT_EQ(run("[sweep]\nelastic.shear_modulus = ['3 MPa', '6 MPa']\n", {"--engine", "elastic"}), 0) << error_;
  EXPECT_CONTAINS_NOT(error_, "has no effect");
}

TEST_F(StudyProgram, SaysWhichValuesAreNotUsed) {
  ASSERT_EQ(run("[elastic]\nvoid_ratio = 0.8\n" + angles, {"--list", "--json"}), 0) << error_;
  EXPECT_CONTAINS(error_, "elastic.void_ratio = 0.8: not used: engine = \"critical_state\" does not read [elastic]");
  ASSERT_EQ(run("[elastic]\nvoid_ratio = 0.8\n" + angles, {"--point", "RD_3deg"}), 0);
  EXPECT_CONTAINS_NOT(error_, "not used");
}

TEST_F(StudyProgram, HasTheLargestVelocityOfAShortRun) {
  ASSERT_EQ(run("[sweep]\namplitude = ['2 kPa', '3 kPa']\n", {"--set", "stop.end_time=0.05 s"}), 0) << error_;
  const Series sweep = read_table(output() / "sweep.dat").series;
  const Column& largest = sweep.column("RD_largest_velocity_median");
  ASSERT_EQ(largest.values.size(), 2U);
  EXPECT_GT(largest.values.front(), 0.0);
  EXPECT_GT(largest.values.back(), largest.values.front());
  EXPECT_CONTAINS(largest.long_name, "over all of the run, which is shorter than 0.1 s");
}

TEST_F(StudyProgram, ListsASampleForEachRecipe) {
  const std::string native = "[sweep]\nangle = ['3 deg', '4 deg']\n[study]\nscheme = ['RD', 'RI']\n";
  ASSERT_EQ(run(native, {"--engine", "native", "--list", "--json"}), 0) << error_;
  std::set<std::string> samples;
  const auto points = nlohmann::json::parse(text_).at("points");
  for (const auto& point : points) samples.insert(point.at("sample").get<std::string>());
  EXPECT_EQ(points.size(), 4U);
  EXPECT_EQ(samples.size(), 2U);
  ASSERT_EQ(run("[sweep]\namplitude = ['1 kPa', '2 kPa']\n", {"--engine", "native", "--list", "--json"}), 0) << error_;
  const auto loadings = nlohmann::json::parse(text_).at("points");
  EXPECT_EQ(loadings.at(0).at("sample"), loadings.at(1).at("sample"));
}

TEST_F(StudyProgram, PlansASweep) {
  ASSERT_EQ(run(angles, {"--dry-run"}), 0) << error_;
  EXPECT_CONTAINS(text_, "sweep.angle = [");
  EXPECT_CONTAINS(text_, "slope.thickness = \"2.0 m\"");
  EXPECT_CONTAINS_NOT(text_, "slope.angle = ");
  EXPECT_CONTAINS(text_, "# run RD_3deg: ");
  EXPECT_FALSE(fs::exists(output()));
}

}  // namespace
}  // namespace flowslide
