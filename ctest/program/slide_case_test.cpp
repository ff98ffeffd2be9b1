// SPDX-License-Identifier: GPL-2.0-or-later
// Cases that slide, as whole programs: on a closed-form sample in place of grains, and once on grains.
#include "program/slide_case.hpp"

#include "dem/make_engine.hpp"
#include "experiment/loading_record.hpp"
#include "grains/packing.hpp"
#include "input/read_samples.hpp"
#include "input/vocabulary.hpp"
#include "program/slide_program.hpp"
#include "record/gnuplot_table.hpp"
#include "support/stress_table.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

TEST_F(SlideProgram, RunsEveryReplicateAndWritesBands) {
  ASSERT_EQ(run({}), 0) << error_;
  for (const char* name : {"RD", "RD_r2", "RD_r3", "RI", "RI_r2", "RI_r3"})
    EXPECT_EQ(read_result(output() / (std::string(name) + ".h5")).provenance.engine, "elastic") << name;
  EXPECT_EQ(read_result(output() / "RD_r3.h5").provenance.replicate, 2);
  const Series band = read_table(output() / "RD_over_time.dat").series;
  EXPECT_EQ(band.columns.front().name, "displacement_median");
  // Three equal samples: no spread, and the median is the slide.
  EXPECT_EQ(band.column("velocity_lowest").values, band.column("velocity_highest").values);
  EXPECT_TRUE(fs::exists(output() / "RI_over_displacement.dat"));
}

TEST_F(SlideProgram, GathersMetricsOfPointsSlidesAndAll) {
  ASSERT_EQ(run({}), 0) << error_;
  TestCase the_case;
  the_case.read(Configuration({scratch_.path() / "case.toml", "quick", {}, {}}));
  const auto metrics = the_case.metrics(output(), {"RD", "RD_r2", "RI"});
  EXPECT_EQ(metrics.at("RD_r2.replicate"), 1.0);
  EXPECT_EQ(metrics.at("RD.replicate.mean"), 0.5);
  EXPECT_EQ(metrics.at("RD.distance"), metrics.at("RD.distance.median"));
  EXPECT_EQ(metrics.at("slides"), 2.0);
  EXPECT_FALSE(metrics.contains("RD.nothing"));
}

TEST_F(SlideProgram, TakesTheNumberOfReplicatesFromTheRunThatAPointIsLike) {
  const auto file = scratch_.write("mine.toml", "point.RD.replicates = 1\npoint.other = { like = 'RD' }\n");
  ASSERT_EQ(run({"--config", file.string(), "--list"}), 0) << error_;
  EXPECT_CONTAINS(text_, "other");
  EXPECT_EQ(text_.find("other_r2"), std::string::npos);
  EXPECT_EQ(text_.find("RD_r2"), std::string::npos);
  EXPECT_CONTAINS(text_, "RI_r3");
}

TEST_F(SlideProgram, RefusesAResultOfAnEditedLoadingTable) {
  const fs::path table = scratch_.write("quake.txt", "0 0\n1 500\n");
  const auto file = scratch_.write("mine.toml", "loading = {history = 'table', file = 'quake.txt'}\nreplicates = 1\n");
  const std::vector<std::string> mine{"--config", file.string(), "--point", "RD"};
  const auto with = [&](const char* option) {
    std::vector<std::string> options = mine;
    options.emplace_back(option);
    return options;
  };
  ASSERT_EQ(run(mine), 0) << error_;
  ASSERT_EQ(run(mine), 0);
  EXPECT_CONTAINS(error_, "the result exists");
  scratch_.write("quake.txt", "# the same numbers\n0 0.0\n1 5e2  # Pa\n");
  ASSERT_EQ(run(mine), 0);
  EXPECT_CONTAINS(error_, "the result exists");

  scratch_.write("quake.txt", "0 0\n1 501\n");
  EXPECT_EQ(run(mine), 2);
  EXPECT_CONTAINS(error_, "is the result of another run (loading table = 2 rows (hash ");
  EXPECT_EQ(run(with("--check")), 2);
  EXPECT_CONTAINS(error_, "is the result of another run (loading table = 2 rows (hash ");
  EXPECT_EQ(run(with("--status")), 0);
  EXPECT_CONTAINS(text_, "outdated");
  EXPECT_EQ(run(with("--so-far")), 2);
  EXPECT_CONTAINS(error_, "RD: left out: of another run: loading table = 2 rows (hash ");

  ASSERT_EQ(run(with("--afresh")), 0) << error_;
  ASSERT_EQ(run(with("--check")), 0) << error_;
  fs::remove(table);  // the history can be read back though the file is gone
  const InputTable kept = read_result(output() / "RD.h5").inputs.at(0);
  EXPECT_EQ(kept.file, "quake.txt");
  EXPECT_EQ(stress_table(kept).time, (std::vector{0.0, 1.0}));
  EXPECT_EQ(stress_table(kept).change, (std::vector{0.0, 501.0}));
}

TEST_F(SlideProgram, LeavesResultsOfAnotherRunOutOfTheBands) {
  ASSERT_EQ(run({"--point", "RD", "--set", "stop.end_time=0.1 s"}), 0) << error_;
  ASSERT_EQ(run({"--point", "RI"}), 0) << error_;
  EXPECT_EQ(run({"--point", "RI", "--check"}), 0) << error_;
  EXPECT_CONTAINS(
      error_, "RD.h5 is the result of another run (stop.end_time = \"0.1 s\" there, \"4.0 s\" now); it is left out");
  EXPECT_TRUE(fs::exists(output() / "RI_over_time.dat"));
  EXPECT_FALSE(fs::exists(output() / "RD_over_time.dat"));
}

TEST_F(SlideProgram, FindsALoadingTableBesideTheFileThatNamesIt) {
  fs::create_directories(scratch_.path() / "mine" / "tables");
  fs::create_directories(scratch_.path() / "elsewhere");
  scratch_.write("mine/tables/quake.txt", "0 0\n1 500\n");
  scratch_.write("elsewhere/quake.txt", "0 0\n1 700\n");
  scratch_.write("quake.txt", "0 0\n1 900\n");
  const auto file =
      scratch_.write("mine/mine.toml", "replicates = 1\nloading = {history = 'table', file = 'tables/quake.txt'}\n");
  const fs::path before = fs::current_path();
  const auto last_change = [&](std::vector<std::string> options) {
    fs::remove_all(output());
    fs::current_path(scratch_.path() / "elsewhere");
    options.insert(options.end(), {"--point", "RD", "--set", "stop.end_time=0.1 s"});
    EXPECT_EQ(run(options), 0) << error_;
    fs::current_path(before);
    return stress_table(read_result(output() / "RD.h5").inputs.at(0)).change.back();
  };
  EXPECT_EQ(last_change({"--config", "../mine/mine.toml"}), 500.0);
  EXPECT_EQ(last_change({"--config", file.string(), "--set", "loading.file=quake.txt"}), 700.0);
  EXPECT_EQ(last_change({"--set", "loading.history=table", "--set", "loading.file=../quake.txt"}), 900.0);
  scratch_.write("case.toml", slide_case_text() +
                                  "[scale.quick]\npoint.RD.loading = {history = 'table', "
                                  "file = 'quake.txt'}\n");
  EXPECT_EQ(last_change({}), 900.0);
}

TEST_F(SlideProgram, TakesTheMeanDiameterFromTheSampleThatWasFound) {
  const std::vector<std::string> search{"--set", "sample.loose.tolerance=2e-3", "--set", "sample.loose.most_trials=50"};
  std::vector<std::string> options{"--engine", "native",
                                   "--point",  "RI",
                                   "--set",    "stop.end_time=2e-3 s",
                                   "--set",    "rows.row_interval=1 ms",
                                   "--set",    "coupling.initial_velocity=0.1 m/s"};
  options.insert(options.end(), search.begin(), search.end());
  ASSERT_EQ(run(options), 0) << error_;

  const Configuration configuration({scratch_.path() / "case.toml",
                                     "quick",
                                     {},
                                     {{"sample.loose.tolerance", "2e-3", ""}, {"sample.loose.most_trials", "50", ""}}});
  const SampleSpecification wanted = read_samples(configuration, read_slope(configuration), 0).at(0);
  const FoundSample found =
      find_sample(*make_engine("native", "/dev/null"), wanted, sample_cache_folder(), {.silent = true});
  const double diameter = found.sample.assembly.mean_diameter();
  ASSERT_NE(diameter, lattice_packing(wanted.recipe.packing).mean_diameter()) << found.trials;  // another seed
  const Series rows = read_result(output() / "RI.h5").series;
  const auto last = [&](const char* name) { return rows.column(name).values.back(); };
  // To rounding: mean diameters of two seeds differ by some 1e-4 of themselves.
  EXPECT_NEAR(last("inertial_number"), last("rate_applied") * diameter * std::sqrt(2650.0 / last("mean_stress")),
              1e-14 * last("inertial_number"));
}

TEST_F(SlideProgram, PlansWithoutWriting) {
  ASSERT_EQ(run({"--dry-run", "--engine", "native", "--point", "RD_r2"}), 0) << error_;
  EXPECT_CONTAINS(text_, "seed 1001\n");
  EXPECT_CONTAINS(text_, "# 40000 global steps of 0.0001 s, about 4e+05 local steps of 1e-05 s\n");
  EXPECT_FALSE(fs::exists(output()));
}

TEST_F(SlideProgram, PlansTheCommandsOfLiggghts) {
  ASSERT_EQ(run({"--dry-run", "--engine", "liggghts", "--point", "RD_r2"}), 0) << error_;
  EXPECT_CONTAINS(text_, "pair_style");
}

TEST_F(SlideProgram, SaysHowToGetAnEngineThatThisBuildHasNot) {
  const std::vector<std::string> built = engine_names_of_build();
  for (const std::string& name : engine_names()) {
    if (std::find(built.begin(), built.end(), name) != built.end()) continue;
    EXPECT_EQ(run({"--engine", name, "--point", "RD_r2"}), 2);
    EXPECT_CONTAINS(error_, "-DFLOWSLIDE_LIGGGHTS=ON");
    EXPECT_EQ(run({"--dry-run", "--engine", name, "--point", "RD_r2"}), 2);
    EXPECT_CONTAINS(error_, "-DFLOWSLIDE_LIGGGHTS=ON");
  }
}

TEST_F(SlideProgram, SlidesOnGrainsAndTakesProfiles) {
  ASSERT_EQ(run({"--engine", "native", "--point", "RD_r2", "--set", "stop.end_time=2 ms", "--set",
                 "point.RD.profile_strains=[0]"}),
            0)
      << error_;
  const Result result = read_result(output() / "RD_r2.h5");
  EXPECT_EQ(result.provenance.engine, "native");
  EXPECT_EQ(values_of({result}, "profiles"), std::vector{3.0});  // at rest, the first snapshot has no ratios
  EXPECT_GT(values_of({result}, "initial_void_ratio").at(0), 0.5);
  EXPECT_EQ(read_table(output() / "RD_r2_profiles.dat").series.rows(), 4U);
  error_.clear();  // its sample is in the cache, and prepared no more
  ASSERT_EQ(run({"--engine", "native", "--point", "RD_r2", "--prepare"}), 0);
  EXPECT_EQ(error_, "");
  ASSERT_EQ(run({"--engine", "native", "--point", "RD_r2", "--set", "stop.end_time=2 ms", "--set",
                 "point.RD.profile_strains=[0]", "--check"}),
            0)
      << error_;
  EXPECT_TRUE(fs::exists(output() / "RD_profiles_band.dat"));
}

TEST_F(SlideProgram, ShearsSamplesAloneBesideTheSlides) {
  scratch_.write("case.toml", slide_and_test_text());
  ASSERT_EQ(run({"--engine", "native", "--point", "alone", "--dry-run"}), 0) << error_;
  EXPECT_CONTAINS(text_, "# 20 steps of 1e-05 s, 10 rows\n");
  ASSERT_EQ(run({"--list"}), 0) << error_;  // on a closed-form sample there is none
  EXPECT_EQ(text_.find("alone"), std::string::npos);
}

TEST_F(SlideProgram, RefusesTheOldNameOfTheTableOfShearTests) {
  EXPECT_EQ(run({"--dry-run", "--set", "element_test.rows=10"}), 2);
  EXPECT_CONTAINS(error_, "--set element_test.rows=10: \"element_test\" is called \"shear_test\" now; rename it");
}

TEST_F(SlideProgram, RefusesAKeyThatTheLoadingHistoryDoesNotUse) {
  EXPECT_EQ(run({"--dry-run", "--set", "loading.rate=1 kPa/s"}), 2);
  EXPECT_EQ(error_,
            "flowslide: --set loading.rate=1 kPa/s: \"loading.rate\" has no effect: history = \"pulse\" does not "
            "use it; remove it\n");
  const auto mine = scratch_.write("mine.toml",
                                   "[point.mine]\nlike = 'RD'\nloading.history = 'rate'\n"
                                   "loading.rate = '1 kPa/s'\nloading.amplitude = '5 kPa'\n");
  EXPECT_EQ(run({"--dry-run", "--config", mine.string()}), 2);
  EXPECT_CONTAINS(error_, "mine.toml:5:9: \"point.mine.loading.amplitude\" has no effect: history = \"rate\" does not");
}

TEST_F(SlideProgram, NamesTheUsersRunThatLacksAKey) {
  std::string text = slide_case_text();
  const std::string stop = "[stop]\nend_time = \"4 s\"\n";
  text.replace(text.find(stop), stop.size(),
               "[point.RD.stop]\nend_time = \"4 s\"\n[point.RI.stop]\nend_time = \"4 s\"\n");
  scratch_.write("case.toml", text + "[scale.quick]\n");
  const auto mine = scratch_.write("mine.toml", "[point.mine]\nfigures = '1'\nsample = 'loose'\nscheme = 'RD'\n");
  EXPECT_EQ(run({"--dry-run", "--config", mine.string()}), 2);
  EXPECT_CONTAINS(error_, "mine.toml:1:8: [point.mine] lacks the key \"point.mine.stop.end_time\": a time");
}

TEST_F(SlideProgram, NamesTheClosedFormSampleInItsResults) {
  ASSERT_EQ(run({"--point", "RD", "--set", "stop.end_time=0.1 s"}), 0) << error_;
  EXPECT_EQ(read_result(output() / "RD.h5").provenance.sample, "elastic");
  ASSERT_EQ(run({"--list"}), 0) << error_;
  EXPECT_CONTAINS(text_, "closed-form sample elastic, RD, pulse");
}

TEST_F(SlideProgram, ShowsWhatASampleTakesFromTheOneThatItIsLike) {
  const auto mine = scratch_.write("mine.toml", "[sample.mine]\nlike = 'loose'\nvoid_ratio = 0.8\n");
  ASSERT_EQ(run({"--dry-run", "--config", mine.string()}), 0) << error_;
  EXPECT_CONTAINS(text_, "\n# sample.mine.drag = \"0.06 kg/s\" ");
  EXPECT_CONTAINS(text_, " # like sample.loose, ");
  EXPECT_EQ(text_.find("# sample.mine.void_ratio"), std::string::npos);
}

TEST_F(SlideProgram, KnowsEveryKeyOfTheVocabulary) {
  scratch_.write("case.toml", slide_and_test_text());
  for (const KeysOfRuns& keys : vocabulary())
    for (const std::string& table : keys.tables)
      for (const std::string& name : keys.names) {
        const bool of_test = table == "point.*" && (name == "shear_rate" || name == "inertial_number");
        std::string key = table + "." + name;
        if (const std::size_t star = key.find('*'); star != std::string::npos)
          key.replace(star, 1, of_test ? "alone" : "RD");
        run({"--dry-run", "--set", key + "=0"});
        EXPECT_CONTAINS_NOT(error_, "unknown");
        EXPECT_CONTAINS_NOT(error_, "no run of this case uses it");
      }
}

TEST_F(SlideProgram, HasTheSameMetricsWhateverRowsAreKept) {
  const auto metrics = [&](const std::string& interval, const std::string& engine) {
    fs::remove_all(output());
    EXPECT_EQ(run({"--engine", engine, "--point", "RD_r2", "--set", "stop.end_time=0.05 s", "--set",
                   "rows.row_interval=" + interval, "--set", "rows.most_rows=10"}),
              0)
        << error_;
    const Result result = read_result(output() / "RD_r2.h5");
    EXPECT_EQ(result.windows.size(), 3U);
    return std::pair(values_of({result}, "peak"), windows_over(result, "time").column("shear_stress").values);
  };
  for (const std::string engine : {"elastic", "native"})
    EXPECT_EQ(metrics("0.1 ms", engine), metrics("40 ms", engine)) << engine;
}

TEST_F(SlideProgram, MeasuresAnElementTestTheSameWhateverRowsAreKept) {
  scratch_.write("case.toml", slide_and_test_text("1e-2"));
  const auto peak = [&](const std::string& rows) {
    fs::remove_all(output());
    EXPECT_EQ(run({"--engine", "native", "--point", "alone", "--set", "shear_test.rows=" + rows}), 0) << error_;
    const Result result = read_result(output() / "alone.h5");
    EXPECT_EQ(result.windows.size(), 2U);
    EXPECT_EQ(parameter_of({result}, "shear_rate"), 5.0);
    return std::pair(values_of({result}, "peak"), windows_over(result, "shear_strain").column("shear_stress").values);
  };
  EXPECT_EQ(peak("10"), peak("123"));
}

TEST_F(SlideProgram, KeepsWhatWasRunUntilItsMetricsCanBeComputed) {
  metrics_fail_ = true;
  EXPECT_NE(run({"--point", "RD"}), 0);
  EXPECT_NEAR(read_table(output() / "RD.dat").series.last("time"), 4.0, 1e-9);
  EXPECT_FALSE(fs::exists(output() / "RD.h5"));  // it would count as complete
  metrics_fail_ = false;
  EXPECT_EQ(run({"--point", "RD"}), 0) << error_;
  EXPECT_CONTAINS(error_, "continues from its checkpoint at t = 4 s");
  const Result result = read_result(output() / "RD.h5");
  EXPECT_NEAR(result.series.last("time"), 4.0, 1e-9);
  EXPECT_EQ(values_of({result}, "distance").size(), 1U);
  EXPECT_EQ(run({"--check"}), 0) << error_;
}

TEST_F(SlideProgram, KeepsItsParametersInTheResult) {
  ASSERT_EQ(
      run({"--point", "RD", "--set", "point.RD.hydraulic_conductivity=1e-3 m/s", "--set", "loading.amplitude=2 kPa"}),
      0)
      << error_;
  const Result result = read_result(output() / "RD.h5");
  EXPECT_EQ(parameter_of({result}, "hydraulic_conductivity"), 1e-3);
  EXPECT_EQ(parameter_of({result}, "amplitude"), 2000.0);
  EXPECT_EQ(parameter_of({result}, "time_step"), 1e-4);
}

TEST_F(SlideProgram, StartsGrainsLinear) {
  // The same sample by the same steps: only the field that it starts from differs, and with it the first stress.
  const auto first_stress = [&](const std::string& linear) {
    std::filesystem::remove_all(output());
    EXPECT_EQ(
        run({"--engine", "native", "--point", "RD_r2", "--set", "stop.end_time=2 ms", "--set", "rows.row_interval=1 ms",
             "--set", "coupling.linear_start=" + linear, "--set", "coupling.initial_velocity=10 cm/s"}),
        0)
        << error_;
    return read_result(output() / "RD_r2.h5").series.column("shear_stress").values.at(1);
  };
  EXPECT_NE(first_stress("true"), first_stress("false"));
}

TEST_F(SlideProgram, RefusesWhatNoSlideHas) {
  const auto table = [this](const std::string& name, const std::string& rows) {
    return "loading = {history = 'table', file = '" + scratch_.write(name, rows).string() + "'}";
  };
  const std::vector<std::pair<std::string, std::string>> all{
      {"coupling.time_step = 0", "must be above 0 s"},
      {"coupling.time_step = nan", "must be above 0 s"},
      {"coupling.time_step = 1e-4", "has no unit: it would be 1e-4 s; write \"1e-4 s\""},
      {"coupling.n_accum = 0", "must be between 1 and"},
      {"slope.hydraulic_conductivity = '-1e-9 m/s'", "must be at least 0 m/s"},
      {"loading.duration = 0", "must be above 0 s"},
      {"slope.angle = '30 deg'", "a sample with friction 0.5 bears less than 0.5"},
      {table("empty.txt", ""), "the loading table is empty"},
      {table("unsorted.txt", "0 1\n2 1\n1 1\n"), "unsorted.txt:3"},
      {table("nan.txt", "0 1\n1 nan\n"), "nan.txt:2"},
  };
  for (const auto& [setting, said] : all) {
    const auto file = scratch_.write("user.toml", setting + "\n");
    EXPECT_EQ(run({"--dry-run", "--engine", "native", "--config", file.string()}), 2) << setting;
    EXPECT_CONTAINS(error_, said);
    EXPECT_FALSE(fs::exists(output()));
  }
}

TEST_F(SlideProgram, RefusesUnstableStepsUnlessToldOtherwise) {
  // omega = sqrt(G/(h_s m)) with G = 40 MPa: 2/omega = 7.87e-3 s.
  EXPECT_EQ(run({"--list", "--set", "coupling.time_step=8 ms"}), 2);
  EXPECT_CONTAINS(error_, "2/omega, allows at most 0.00787 s");
  EXPECT_CONTAINS(error_, "--allow-unstable");
  EXPECT_EQ(run({"--list", "--set", "coupling.time_step=8 ms", "--allow-unstable"}), 0) << error_;
}

}  // namespace
}  // namespace flowslide
