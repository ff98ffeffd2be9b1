// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_coupling.hpp"

#include <cmath>

#include "configuration/error.hpp"
#include "experiment/loading_record.hpp"
#include "grains/measures.hpp"
#include "input/read_samples.hpp"
#include "support/messages.hpp"
#include "support/stress_table.hpp"

namespace flowslide::read_coupling_test {
namespace {

constexpr const char* text = R"([slope]
saturated_density = "2000 kg/m^3"
dry_density = "1500 kg/m^3"
thickness = "2 m"
liquefiable_thickness = "0.2 m"
water_table = "0.2 m"
angle = "5 deg"
hydraulic_conductivity = "1e-3 m/s"
[loading]
history = "pulse"
amplitude = "3 kPa"
duration = "2 s"
[coupling]
time_step = "1e-4 s"
local_time_step = "1e-5 s"
rate = "constant_inertial_number"
inertial_number = 1e-4
smallest_rate = "0.5 1/s"
smallest_rate_from = "2 %"
passing = "carry_remainder"
n_accum = 10
most_steps = 100000
consolidation = "exponential"
residual = "fades"
shear_modulus = "15 MPa"
oedometric_modulus = "40 MPa"
allow_unstable = false
[stop]
end_time = "10 s"
end_shear_strain = 5
sliding_velocity = "1 cm/s"
[rows]
row_interval = "10 ms"
row_strain = "1 %"
most_rows = 1000
)";

const GrainScale grains{6e-3, 2650.0};

Configuration with(const std::string& from = "", const std::string& to = "") {
  std::string changed = text;
  changed.replace(changed.find(from), from.size(), to);
  return Configuration::from_text(changed, "case.toml");
}

SlideSettings coupling_of(const Configuration& configuration) {
  return read_coupling(configuration, "coupling", read_slope(configuration), grains);
}

std::string coupling_complaint(const std::string& from, const std::string& to) {
  return message_of<ConfigurationError>([&] { coupling_of(with(from, to)); });
}

StressHistory loading_of(const std::string& table) {
  return read_loading(Configuration::from_text("[loading]\n" + table, "case.toml"), "loading");
}
std::string loading_complaint(const std::string& table) {
  return message_of<ConfigurationError>([&] { loading_of(table); });
}

TEST(ReadLoading, TakesEveryHistory) {
  EXPECT_TRUE(std::holds_alternative<NoChange>(loading_of("history = \"constant\"")));
  const StressHistory at_once = loading_of("history = \"constant\"\nchange = \"6 kPa\"");
  for (const double time : {0.0, 10.0}) EXPECT_EQ(stress_change(at_once, time), 6e3);
  const auto pulse = std::get<SinePulse>(loading_of("history = \"pulse\"\namplitude = \"3 kPa\"\nduration = \"2 s\""));
  EXPECT_EQ(pulse.amplitude, 3e3);
  EXPECT_EQ(pulse.duration, 2.0);
  const auto rate = std::get<ConstantRate>(loading_of("history = \"rate\"\nrate = \"1e3 kPa/min\""));
  EXPECT_NEAR(rate.rate, 1e6 / 60.0, 1e-9);  // rounding
  EXPECT_TRUE(std::isinf(rate.duration));
  EXPECT_EQ(std::get<ConstantRate>(loading_of("history = \"rate\"\nrate = \"100 Pa/s\"\nduration = \"3 s\"")).duration,
            3.0);
  EXPECT_EQ(std::get<ConstantRate>(loading_of("history = \"rate\"\nrate = \"-100 Pa/s\"\nfinal_change = \"-500 Pa\""))
                .duration,
            5.0);
}

TEST(ReadLoading, TakesATableBesideTheFileThatNamesIt) {
  const ScratchFolder folder;
  folder.write("quake.txt", "0 0\n1 500\n");
  const auto configuration = Configuration::from_text("[x.loading]\nhistory = \"table\"\nfile = \"quake.txt\"\n",
                                                      (folder.path() / "mine.toml").string());
  const StressHistory loading = read_loading(configuration, "x.loading");
  EXPECT_EQ(std::get<StressTable>(loading).change.back(), 500.0);
  const std::vector<InputTable> inputs = loading_inputs(configuration, "x.loading", loading);
  EXPECT_EQ(stress_table(inputs.at(0)).time, (std::vector{0.0, 1.0}));
  EXPECT_EQ(inputs.at(0).file, "quake.txt");
}

TEST(ReadLoading, HasNoInputFileWithoutATable) {
  const auto configuration = Configuration::from_text("[loading]\nhistory = \"constant\"\nchange = \"6 kPa\"\n");
  EXPECT_TRUE(loading_inputs(configuration, "loading", read_loading(configuration, "loading")).empty());
}

TEST(ReadLoading, RefusesWhatIsNoLoading) {
  EXPECT_CONTAINS(loading_complaint("history = \"puls\""), "did you mean \"pulse\"?");
  EXPECT_CONTAINS(loading_complaint("history = \"pulse\"\namplitude = \"1 Pa\"\nduration = 0"),
                  "case.toml:4:12: loading.duration = 0 is not allowed: it must be above 0 s");
  EXPECT_CONTAINS(loading_complaint("history = \"pulse\"\namplitude = \"1 Pa\"\nduration = \"-2 s\""), "above 0 s");
  EXPECT_CONTAINS(loading_complaint("history = \"pulse\"\namplitude = \"3 m\"\nduration = \"2 s\""), "amplitude");
  EXPECT_CONTAINS(loading_complaint("history = \"rate\"\nrate = \"100 Pa/s\"\nfinal_change = \"-500 Pa\""),
                  "is never reached");
  EXPECT_CONTAINS(loading_complaint("history = \"rate\"\nrate = 0\nfinal_change = \"500 Pa\""),
                  "never reached at the rate 0");
  EXPECT_CONTAINS(
      loading_complaint("history = \"rate\"\nrate = \"1 Pa/s\"\nfinal_change = \"5 Pa\"\nduration = \"1 s\""),
      "conflicts with \"loading.duration\", which is given too");
  EXPECT_CONTAINS(loading_complaint("history = \"table\"\nfile = \"nowhere.txt\""), "nowhere.txt");
}

TEST(ReadCoupling, TakesEveryValue) {
  const SlideSettings settings = coupling_of(with());
  EXPECT_EQ(settings.slope.hydraulic_conductivity, 1e-3);
  EXPECT_EQ(settings.time_step, 1e-4);
  const auto& rule = std::get<ConstantInertialNumber>(settings.rate);
  EXPECT_EQ(rule.inertial_number, 1e-4);
  EXPECT_EQ(rule.smallest_rate, 0.5);
  EXPECT_EQ(rule.smallest_rate_from, 0.02);
  EXPECT_EQ(rule.grains.mean_diameter, 6e-3);
  EXPECT_EQ(std::get<CarryRemainder>(settings.passing.rule).least_steps, 10);
  EXPECT_EQ(settings.passing.time_step, 1e-5);
  EXPECT_EQ(settings.passing.most_steps, 100'000);
  EXPECT_EQ(settings.consolidation, ConsolidationScheme::exponential);
  EXPECT_EQ(settings.residual, ResidualTreatment::fades);
  EXPECT_EQ(settings.oedometric_modulus, 40e6);
  EXPECT_EQ(settings.initial_velocity, 0.0);
  EXPECT_EQ(coupling_of(with("n_accum = 10", "n_accum = 10\ninitial_velocity = \"1 cm/s\"")).initial_velocity, 0.01);
}

TEST(ReadCoupling, TakesHowOftenTheStressIsMeasuredAndWhenASampleRests) {
  EXPECT_EQ(coupling_of(with()).stress_interval, 1);
  EXPECT_FALSE(coupling_of(with()).rest);
  const Configuration resting = with("n_accum = 10", R"(n_accum = 10
stress_interval = 7
rest_stress = "30 Pa"
probed_strain = "1 %"
rested_strain = 0.2)");
  SlopeProperties undrained = read_slope(resting);
  undrained.hydraulic_conductivity = 0.0;
  const SlideSettings settings = read_coupling(resting, "coupling", undrained, grains);
  EXPECT_EQ(settings.stress_interval, 7);
  EXPECT_EQ(settings.rest->normal_stress, 30.0);
  EXPECT_EQ(settings.rest->probed_strain, 0.01);
  EXPECT_EQ(settings.rest->rested_strain, 0.2);
  EXPECT_CONTAINS(coupling_complaint("n_accum = 10", "n_accum = 10\nrest_stress = \"30 Pa\""),
                  "coupling.probed_strain");
  EXPECT_CONTAINS(coupling_complaint("n_accum = 10", "n_accum = 10\nstress_interval = 0"), "coupling.stress_interval");
}

TEST(ReadCoupling, TakesALocalTimeStepThatFollowsTheContacts) {
  EXPECT_FALSE(coupling_of(with()).adaptive);
  const std::string key = "n_accum = 10\nlargest_local_time_step = ";
  const SlideSettings settings = coupling_of(with("n_accum = 10", key + "\"4e-5 s\""));
  EXPECT_EQ(settings.adaptive->smallest, 1e-5);
  EXPECT_EQ(settings.adaptive->largest, 4e-5);
  EXPECT_CONTAINS(coupling_complaint("n_accum = 10", key + "\"9e-6 s\""), "is below local_time_step, 1e-05 s");
}

TEST(ReadCoupling, TakesEveryChoice) {
  const auto rate = [](const std::string& name) {
    return coupling_of(with("\"constant_inertial_number\"", '"' + name + '"')).rate;
  };
  EXPECT_TRUE(std::holds_alternative<GlobalRate>(rate("global")));
  EXPECT_TRUE(std::holds_alternative<GlobalRateAtLeastQuasiStatic>(rate("at_least_quasi_static")));
  // I = 1e-4 at the sigma_0 of eq. 9.
  EXPECT_EQ(std::get<ConstantStrainRate>(rate("constant")).rate,
            shear_rate_for(1e-4, 6e-3, 2650.0, initial_normal_stress(read_slope(with()))));
  const auto rule = [](const std::string& name) {
    return coupling_of(with("\"carry_remainder\"", '"' + name + '"')).passing.rule;
  };
  EXPECT_EQ(std::get<AccumulateAndReset>(rule("accumulate_and_reset")).least_steps, 10);
  EXPECT_TRUE(std::holds_alternative<WholeIncrement>(rule("whole_increment")));
  EXPECT_TRUE(std::holds_alternative<VariableTimeStep>(rule("variable_time_step")));
  EXPECT_EQ(coupling_of(with("\"exponential\"", "\"euler\"")).consolidation, ConsolidationScheme::euler);
  EXPECT_EQ(coupling_of(with("\"fades\"", "\"stays\"")).residual, ResidualTreatment::stays);
  EXPECT_EQ(coupling_of(with("\"fades\"", "\"left_out\"")).residual, ResidualTreatment::left_out);
}

TEST(ReadCoupling, LeavesNoKeyUnknown) {
  for (const char* rate : {"global", "constant", "constant_inertial_number", "at_least_quasi_static"}) {
    const Configuration configuration = with("\"constant_inertial_number\"", std::string("\"") + rate + '"');
    coupling_of(configuration);
    read_loading(configuration, "loading");
    read_stop(configuration, "stop");
    read_row_spacing(configuration, "rows");
    EXPECT_NO_THROW(configuration.reject_unknown()) << rate;
  }
}

TEST(ReadCoupling, RefusesValuesOutOfRange) {
  EXPECT_CONTAINS(coupling_complaint("time_step = \"1e-4 s\"", "time_step = 0"),
                  "case.toml:14:13: coupling.time_step = 0 is not allowed: it must be above 0 s");
  EXPECT_CONTAINS(coupling_complaint("time_step = \"1e-4 s\"", "time_step = \"-1 ms\""), "above 0 s");
  EXPECT_CONTAINS(coupling_complaint("n_accum = 10", "n_accum = 0"),
                  "coupling.n_accum = 0 is not allowed: it must be between 1");
  EXPECT_CONTAINS(coupling_complaint("most_steps = 100000", "most_steps = 9"), "it must be between 10");
  EXPECT_CONTAINS(coupling_complaint("\"1e-3 m/s\"", "\"-1e-3 m/s\""), "slope.hydraulic_conductivity");
  EXPECT_CONTAINS(coupling_complaint("inertial_number = 1e-4", "inertial_number = 0"), "it must be above 0");
  EXPECT_CONTAINS(coupling_complaint("\"0.5 1/s\"", "\"-0.5 1/s\""), "coupling.smallest_rate");
  EXPECT_CONTAINS(coupling_complaint("\"2 %\"", "\"-2 %\""), "coupling.smallest_rate_from");
  EXPECT_CONTAINS(coupling_complaint("\"carry_remainder\"", "\"carry\""), "did you mean \"carry_remainder\"?");
}

TEST(ReadStrainPassing, BlamesTheOneOfNAccumAndMostStepsThatTheUserGives) {
  const ScratchFolder scratch;
  const auto complaint = [&](const std::string& users) {
    Layers layers{.case_file = scratch.write("case.toml", text), .scale = {}, .user_file = {}, .overrides = {}};
    layers.user_file = scratch.write("mine.toml", "[coupling]\npassing = \"carry_remainder\"\n" + users);
    const Configuration configuration(layers);
    return message_of<ConfigurationError>([&] { read_strain_passing(configuration, "coupling", nullptr); });
  };
  EXPECT_CONTAINS(
      complaint("n_accum = 200000\n"),
      "mine.toml:3:11: coupling.n_accum = 200000 is above coupling.most_steps = 100000, the largest number of "
      "local steps of one exchange; choose n_accum from 1 to 100000");
  EXPECT_CONTAINS(complaint("n_accum = 300\nmost_steps = 200\n"), "n_accum = 300 is above coupling.most_steps = 200");
  EXPECT_CONTAINS(complaint("most_steps = 9\n"), "mine.toml:3:14: coupling.most_steps = 9 is not allowed");
}

TEST(ReadCoupling, RefusesATimeStepBeyondTheLimitOfStabilityUnlessAllowed) {
  // 2/omega: omega = sqrt(15e6/(0.2 * 3100)) = 155.5 /s, 12.9 ms.
  EXPECT_NO_THROW(coupling_of(with("time_step = \"1e-4 s\"", "time_step = \"12.8 ms\"")));
  const std::string sliding = coupling_complaint("time_step = \"1e-4 s\"", "time_step = \"13 ms\"");
  EXPECT_CONTAINS(sliding, "case.toml:14:13: coupling.time_step = \"13 ms\" is unstable: sliding on a sample of G = ");
  EXPECT_CONTAINS(sliding, "allows at most 0.0129 s; choose a smaller step, or give --allow-unstable");
  // 2/(M C) at k = 1e-3 m/s and 40 MPa: 389.42/(1e-3 * 40e6) = 9.74 ms; of no interest to the exponential.
  const auto euler = [](const std::string& step, const std::string& allow) {
    std::string changed = text;
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"\"1e-4 s\"", step},
                                   {"\"exponential\"", "\"euler\""},
                                   {"allow_unstable = false", "allow_unstable = " + allow}})
      changed.replace(changed.find(from), from.size(), to);
    return coupling_of(Configuration::from_text(changed, "case.toml"));
  };
  EXPECT_NO_THROW(euler("\"9.7 ms\"", "false"));
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { euler("\"9.8 ms\"", "false"); }),
                  "forward Euler for drainage with M = 4e+07 Pa, 2/(M C), allows at most 0.00974 s");
  EXPECT_DOUBLE_EQ(euler("\"9.8 ms\"", "true").time_step, 9.8e-3);
}

TEST(ReadCoupling, RefusesPortionsThatHideThePeakOfTheSample) {
  const std::string rate = "inertial_number = 1e-4";  // 0.0545 1/s at sigma_0; the floor comes later
  EXPECT_NO_THROW(coupling_of(with("n_accum = 10", "n_accum = 1700")));
  EXPECT_CONTAINS(coupling_complaint("n_accum = 10", "n_accum = 2000"), "passes a strain of 0.00109 at once");
  EXPECT_CONTAINS(coupling_complaint(rate, "inertial_number = 1e-1"), "n_accum = 10 passes a strain of");
}

TEST(ReadCoupling, RefusesToHoldTheStressOfRDForLongerThanASwing) {
  const std::string rate = "rate = \"constant_inertial_number\"\ninertial_number = 1e-4";
  Configuration configuration = with(rate, "rate = \"global\"");
  EXPECT_NO_THROW(coupling_of(configuration));  // 1e-4 s; 2/omega is 12.9 ms
  const std::string rest = "\npassing = \"carry_remainder\"\nn_accum = 10";
  EXPECT_CONTAINS(coupling_complaint(rate + "\nsmallest_rate = \"0.5 1/s\"\nsmallest_rate_from = \"2 %\"" + rest,
                                     "rate = \"global\"" + rest.substr(0, rest.size() - 2) + "1400"),
                  "holds the stress for 0.014 s");
}

TEST(ReadCoupling, CountsHowSeldomTheStressIsMeasuredAndTheLargestLocalTimeStep) {
  const std::string rate = "rate = \"constant_inertial_number\"\ninertial_number = 1e-4";
  const std::string floor = "\nsmallest_rate = \"0.5 1/s\"\nsmallest_rate_from = \"2 %\"";
  const std::string passing = "\npassing = \"carry_remainder\"\nn_accum = 10";
  const auto complaint = [&](const std::string& more) {
    return coupling_complaint(rate + floor + passing, "rate = \"global\"" + passing + more);
  };
  EXPECT_CONTAINS(complaint("\nstress_interval = 140"), "n_accum = 10 holds the stress for 0.014 s");
  EXPECT_CONTAINS(complaint("\nstress_interval = 40\nlargest_local_time_step = \"4e-5 s\""),
                  "n_accum = 10 holds the stress for 0.016 s");
  EXPECT_CONTAINS(coupling_complaint(passing, "\npassing = \"whole_increment\"\nstress_interval = 2000"),
                  "stress_interval = 2000 passes a strain of 0.00109 at once");
}

TEST(ReadCoupling, RefusesARestWhereItsStrainWouldBeMissed) {
  const std::string rate = "rate = \"constant_inertial_number\"\ninertial_number = 1e-4";
  const std::string floor = "\nsmallest_rate = \"0.5 1/s\"\nsmallest_rate_from = \"2 %\"";
  const std::string rest = "\nrest_stress = \"30 Pa\"\nprobed_strain = \"1 %\"\nrested_strain = 0.2";
  EXPECT_CONTAINS(coupling_complaint(rate + floor, "rate = \"global\"" + rest), "passes the rate of the slope");
  EXPECT_CONTAINS(coupling_complaint(rate, rest.substr(1) + "\n" + rate), "by which the sample would regain strength");
}

TEST(ReadStop, TakesWhatThereIs) {
  const StopConditions all = read_stop(with(), "stop");
  EXPECT_EQ(all.end_time, 10.0);
  EXPECT_EQ(all.end_shear_strain, 5.0);
  EXPECT_EQ(all.sliding_velocity, 0.01);
  const StopConditions one = read_stop(Configuration::from_text("[s]\nend_time = \"3 s\"\n"), "s");
  EXPECT_TRUE(std::isinf(one.end_shear_strain) && std::isinf(one.sliding_velocity));
  EXPECT_TRUE(std::isinf(all.end_velocity));
  EXPECT_EQ(read_stop(with("end_shear_strain = 5", "end_velocity = \"2 m/s\""), "stop").end_velocity, 2.0);
  const std::string message = message_of<ConfigurationError>([] { read_stop(with("\"10 s\"", "0"), "stop"); });
  EXPECT_CONTAINS(message, "stop.end_time = 0 is not allowed: it must be above 0 s");
}

TEST(ReadRowSpacing, NeedsADistance) {
  const RowSpacing spacing = read_row_spacing(with(), "rows");
  EXPECT_EQ(spacing.interval, 0.01);
  EXPECT_EQ(spacing.strain, 0.01);
  EXPECT_EQ(spacing.most_rows, 1000);
  EXPECT_CONTAINS(message_of<ConfigurationError>([] {
                    read_row_spacing(Configuration::from_text("[rows]\nmost_rows = 100\n", "case.toml"), "rows");
                  }),
                  "rows.most_rows = 100 does not give the spacing of rows; give row_interval, row_strain or both");
}

TEST(CheckStrength, RefusesASlopeThatIsSteeperThanItsSampleBears) {
  const auto check = [](const std::string& angle, double friction) {
    const Configuration configuration = with("\"5 deg\"", angle);
    check_strength(configuration, read_slope(configuration), friction);
  };
  // tau_0/sigma_0 = 0.0935 at 5 degrees and 0.0749 at 4.
  EXPECT_NO_THROW(check("\"5 deg\"", 0.1));
  const std::string message = message_of<ConfigurationError>([&] { check("\"5 deg\"", 0.09); });
  EXPECT_CONTAINS(message, "case.toml:7:9: slope.angle = \"5 deg\" makes tau_0/sigma_0 = 0.0935");
  EXPECT_CONTAINS(message, "make the slope flatter");
  EXPECT_NO_THROW(check("\"4 deg\"", 0.09));
}

}  // namespace
}  // namespace flowslide::read_coupling_test
