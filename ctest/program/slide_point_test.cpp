// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/slide_point.hpp"

#include <algorithm>

#include "configuration/error.hpp"
#include "input/read_samples.hpp"
#include "program/slide_case_text.hpp"
#include "support/messages.hpp"

namespace flowslide::slide_point_test {
namespace {

SlidePoint read(const std::string& text, const std::string& name, int replicate = 0,
                const std::string& engine = "native") {
  const auto configuration = Configuration::from_text(text);
  const SlopeProperties slope = read_slope(configuration);
  const auto samples = read_samples(configuration, slope, replicate);
  return read_slide_point(configuration, name, {replicate, samples, slope, engine});
}

TEST(SlidePoint, TakesItsSchemeOverTheCouplingOfAll) {
  const SlidePoint point = read(slide_case_text(), "RI");
  EXPECT_TRUE(std::holds_alternative<ConstantInertialNumber>(point.settings.rate));
  EXPECT_TRUE(std::holds_alternative<WholeIncrement>(point.settings.passing.rule));
  EXPECT_EQ(point.settings.time_step, 1e-4);
  EXPECT_EQ(point.settings.passing.time_step, 1e-5);
  EXPECT_EQ(point.point.figures, std::vector<std::string>{"12"});
  EXPECT_TRUE(point.published);
  EXPECT_NE(point.point.description.find("RI, pulse of 3 kPa over 2 s, k = 0 m/s"), std::string::npos);
  const auto number = std::find_if(point.parameters.begin(), point.parameters.end(),
                                   [](const Metric& parameter) { return parameter.name == "inertial_number"; });
  ASSERT_NE(number, point.parameters.end());  // of the rate rule, as it was asked for
  EXPECT_EQ(number->value, 1e-4);
}

TEST(SlidePoint, OverridesWhatItNames) {
  const SlidePoint point = read(slide_case_text() + R"([point.own]
figures = "13"
sample = "loose"
scheme = "RD"
hydraulic_conductivity = "1e-4 m/s"
profile_strains = [0.1]
coupling.time_step = "2e-4 s"
loading.amplitude = "5 kPa"
stop.end_time = "9 s"
rows.row_interval = "1 s"
)", "own");
  EXPECT_EQ(point.settings.time_step, 2e-4);
  EXPECT_EQ(std::get<SinePulse>(point.settings.loading).amplitude, 5e3);
  EXPECT_EQ(point.settings.slope.hydraulic_conductivity, 1e-4);
  EXPECT_EQ(point.stop.end_time, 9.0);
  EXPECT_EQ(point.rows.interval, 1.0);
  EXPECT_EQ(point.profiles.strains, std::vector{0.1});
}

TEST(SlidePoint, TakesWhatItLeavesOutFromTheOneThatItIsLike) {
  const SlidePoint point = read(slide_case_text() + R"([point.first]
figures = "13"
sample = "loose"
scheme = "RD"
coupling.time_step = "2e-4 s"
loading.amplitude = "5 kPa"
[point.second]
like = "first"
coupling.n_accum = 3
)", "second");
  EXPECT_EQ(point.point.name, "second");
  EXPECT_EQ(point.point.figures, std::vector<std::string>{"13"});
  EXPECT_EQ(point.settings.time_step, 2e-4);
  EXPECT_EQ(std::get<CarryRemainder>(point.settings.passing.rule).least_steps, 3);
  EXPECT_EQ(std::get<SinePulse>(point.settings.loading).amplitude, 5e3);
  EXPECT_CONTAINS(
      message_of<ConfigurationError>([] { read(slide_case_text() + "[point.own]\nlike = \"RF\"\n", "own"); }),
      "point.own.like");
}

TEST(SlidePoint, MayHaveAnEngineOfItsOwn) {
  const auto with_engine = [](const std::string& engine) {
    return slide_case_text() + "[point.own]\nlike = \"RD\"\nengine = \"" + engine + "\"\n";
  };
  EXPECT_EQ(read(with_engine("native-mixed"), "own").engine, "native-mixed");
  EXPECT_EQ(read(with_engine("native-mixed"), "RD").engine, "native");
  EXPECT_EQ(read(with_engine("native-mixed"), "own", 0, "elastic").engine, "elastic");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read(with_engine("lammps"), "own"); }), "point.own.engine");
}

TEST(SlidePoint, HasASampleOfItsOwnInEveryReplicate) {
  EXPECT_EQ(read(slide_case_text(), "RI").point.name, "RI");
  const SlidePoint third = read(slide_case_text(), "RI", 2);
  EXPECT_EQ(third.point.name, "RI_r3");
  EXPECT_EQ(third.name, "RI");
  EXPECT_NE(third.sample.recipe.packing.seed, read(slide_case_text(), "RI").sample.recipe.packing.seed);
}

TEST(SlidePoint, PredictsItsStepsOnASampleWithoutStrength) {
  // RD runs at the clock of the slope: 4 s in steps of 1e-5 s.
  const SlidePoint global = read(slide_case_text(), "RD");
  EXPECT_NEAR(predicted_steps(global.settings, global.stop), 4e5, 1e3);
  EXPECT_GT(global.point.predicted_seconds, 0.0);
  EXPECT_EQ(read(slide_case_text(), "RD", 2).point.curve, "RD");
  const auto& sites = global.sample.recipe.packing.counts;
  EXPECT_EQ(global.point.grains, sites[0] * sites[1] * sites[2]);
  EXPECT_EQ(global.point.sample, global.sample.name + "_seed" + std::to_string(global.sample.recipe.packing.seed));
  EXPECT_EQ(read(slide_case_text(), "RD", 0, "elastic").point.predicted_seconds, 0.0);
  // RI at the floor of 2 1/s: x = tau_0 t^2/(2m), and the pulse adds A T/(pi m) (2 (t - T/2)) from its end on.
  const SlidePoint slow = read(slide_case_text(), "RI");
  const double mass = mass_per_area(slow.settings.slope), shear = initial_shear_stress(slow.settings.slope);
  const double distance = 0.5 * shear * 16.0 / mass + 3e3 * 2.0 / 3.14159265 / mass * 2.0 * 3.0;
  EXPECT_NEAR(predicted_steps(slow.settings, slow.stop), distance / 0.2 / 2.0 / 1e-5, 0.05 * distance / 4e-6);
}

TEST(SlidePoint, IsAnElementTestWhereItNamesAFinalStrainAndNoScheme) {
  const SlidePoint point = read(slide_case_text() + R"([point.alone]
figures = "6"
sample = "loose"
inertial_number = 1e-2
final_strain = 0.05
coupling.local_time_step = "5e-6 s"
[shear_test]
rows = 50
)",
                                "alone", 1);
  ASSERT_TRUE(point.test);
  EXPECT_EQ(point.test->rows, 50);
  EXPECT_EQ(point.settings.passing.time_step, 5e-6);
  EXPECT_EQ(point.point.name, "alone_r2");
  EXPECT_GT(point.point.predicted_seconds, 0.0);
  EXPECT_FALSE(read(slide_case_text(), "RD").test);
}

TEST(SlidePoint, TakesRatesFromTheMeanDiameterOfItsSample) {
  const SlidePoint planned = read(slide_case_text(), "RI");
  const auto grains = [](const SlidePoint& point) {
    return std::get<ConstantInertialNumber>(point.settings.rate).grains.mean_diameter;
  };
  const SlidePoint found = on_sample(planned, 5.5e-3);
  EXPECT_EQ(found.grains.mean_diameter, 5.5e-3);
  EXPECT_EQ(grains(found), 5.5e-3);
  EXPECT_EQ(grains(planned), planned.grains.mean_diameter);
  EXPECT_NE(planned.grains.mean_diameter, 5.5e-3);
  const SlidePoint test = read(slide_case_text() +
                                   "[point.alone]\nfigures = \"6\"\nsample = \"loose\"\n"
                                   "inertial_number = 1e-2\nfinal_strain = 0.05\n[shear_test]\nrows = 50\n",
                               "alone");
  const double ratio = on_sample(test, 0.5 * test.grains.mean_diameter).test->shear_rate / test.test->shear_rate;
  EXPECT_NEAR(ratio, 2.0, 1e-14);  // at a given I the rate falls with the diameter
}

TEST(SlidePoint, KnowsWhatElseDecidesItsResult) {
  EXPECT_EQ(read(slide_case_text(), "RD", 0, "elastic").point.inputs.engine, "elastic");
  EXPECT_TRUE(read(slide_case_text(), "RD").point.inputs.tables.empty());
  const ScratchFolder folder;
  const auto file = folder.write("quake.txt", "0 0\n1 500\n");
  const auto own = "[point.own]\nlike = \"RD\"\nloading = {history = \"table\", file = \"" + file.string() + "\"}\n";
  EXPECT_EQ(read(slide_case_text() + own, "own").point.inputs.tables.at(0).rows.rows(), 2U);
  EXPECT_TRUE(read(slide_case_text() + own, "RD").point.inputs.tables.empty());
}

TEST(SlidePoint, MayStartLinear) {
  EXPECT_FALSE(read(slide_case_text(), "RD").linear_start);
  const std::string own = "[point.own]\nfigures = \"6\"\nsample = \"loose\"\nscheme = \"RD\"\n";
  EXPECT_TRUE(read(slide_case_text() + own + "coupling.linear_start = true\n", "own").linear_start);
}

TEST(SlidePoint, PredictsAStepForEachIncrementThatIsPassedAtOnce) {
  SlidePoint point = read(slide_case_text(), "RD");
  const double waiting = predicted_steps(point.settings, point.stop);
  point.settings.passing.rule = VariableTimeStep{};
  EXPECT_NEAR(predicted_steps(point.settings, point.stop) - waiting, point.stop.end_time / 1e-4, 100.0);
  // At a constant rate the strain counts, not the time.
  point.settings.rate = ConstantStrainRate{1.0};
  const double slow = predicted_steps(point.settings, point.stop);
  point.settings.rate = ConstantStrainRate{2.0};
  EXPECT_LT(predicted_steps(point.settings, point.stop), 0.6 * slow);
}

TEST(SlidePoint, RefusesWhatIsNotThere) {
  const auto complaint = [](const std::string& more) {
    return message_of<ConfigurationError>([&] { read(slide_case_text() + more, "bad"); });
  };
  const std::string start = "[point.bad]\nfigures = \"12\"\n";
  EXPECT_CONTAINS(complaint(start + "sample = \"lose\"\nscheme = \"RD\"\n"), "did you mean \"loose\"?");
  EXPECT_CONTAINS(complaint(start + "sample = \"loose\"\nscheme = \"RDD\"\n"), "did you mean \"RD\"?");
  EXPECT_CONTAINS(
      complaint(start + "sample = \"loose\"\nscheme = \"RD\"\ncoupling.local_time_step = \"2e-5 s\"\n"),
      "point.bad.coupling.local_time_step");
  EXPECT_CONTAINS(complaint(start + "sample = \"loose\"\nscheme = \"RD\"\nhydraulic_conductivity = \"-1 m/s\"\n"),
                  "it must be at least 0 m/s");
}

TEST(SlidePoint, RefusesWhatItsKeysMakeTogetherBeforeAnythingRuns) {
  const auto complaint = [](const std::string& point, const std::string& engine = "native") {
    return message_of<ConfigurationError>([&] {
      read(slide_case_text() + "[point.bad]\nfigures = \"12\"\nsample = \"loose\"\n" + point, "bad", 0, engine);
    });
  };
  EXPECT_CONTAINS(complaint("scheme = \"RD\"\nloading.duration = \"0.9 ms\"\n"),
                  "run bad: duration of the pulse in dt_G is 9");
  EXPECT_CONTAINS(complaint("final_strain = 1\nshear_rate = \"1e-14 1/s\"\nrows = 10\n"),
                  "run bad: a strain of 1 at the rate 1e-14 1/s");
}

TEST(SlidePoint, NeedsASampleThatIsPreparedToTheStressesOfItsSlope) {
  std::string text = slide_case_text();
  text.replace(text.find("isotropic = false"), 17, "isotropic = true");
  EXPECT_CONTAINS(
      message_of<ConfigurationError>([&] { read(text, "RD"); }),
      "is prepared to tau = 0 Pa, but the slope starts with 2650 Pa: they may differ by 0.05 sigma_0 at most; "
      "choose a sample that is not isotropic, or set residual = \"stays\"");
  EXPECT_NO_THROW(read(text, "RD", 0, "elastic"));  // in balance with any slope
  text.replace(text.find("residual = \"fades\""), 18, "residual = \"stays\"");
  EXPECT_NO_THROW(read(text, "RD"));
}

}  // namespace
}  // namespace flowslide::slide_point_test
