// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "samples_text.hpp"

namespace flowslide {
namespace {

TEST(ReadSlope, TakesEveryPropertyInSiUnits) {
  const SlopeProperties slope = read_slope(with());
  EXPECT_EQ(slope.saturated_density, 2000.0);
  EXPECT_EQ(slope.dry_density, 1500.0);
  EXPECT_EQ(slope.thickness, 2.0);
  EXPECT_EQ(slope.liquefiable_thickness, 0.2);
  EXPECT_EQ(slope.water_table, 0.2);
  EXPECT_NEAR(slope.angle, std::numbers::pi / 36.0, 1e-16);  // rounding
  EXPECT_EQ(slope.hydraulic_conductivity, 1e-3);
}

TEST(ReadSlope, RefusesWhatNoSlopeHas) {
  EXPECT_CONTAINS(complaint("thickness = \"2 m\"", "thickness = \"-2 m\""),
                  "case.toml:5:13: slope.thickness = \"-2 m\" is not allowed: it must be above 0 m; change it");
  EXPECT_CONTAINS(complaint("\"5 deg\"", "\"120 deg\""), "case.toml:8:9: slope.angle = \"120 deg\" is not allowed");
  EXPECT_CONTAINS(complaint("\"1500 kg/m^3\"", "\"1500 kg\""), "case.toml:4:15: slope.dry_density");
  // Rules that span two properties: the message gives value, range and remedy.
  const std::string message =
      message_of<ConfigurationError>([] { read_slope(with("water_table = \"0.2 m\"", "water_table = \"3 m\"")); });
  EXPECT_CONTAINS(message, "water table is 3; allowed: 0 to 2");
  EXPECT_CONTAINS(message, "Measure it from the base");
}

TEST(ReadMaterial, TakesEveryProperty) {
  const Material material = read_material(with());
  EXPECT_EQ(material.density, 2650.0);
  EXPECT_EQ(material.youngs_modulus, 2e9);
  EXPECT_EQ(material.poisson_ratio, 0.25);
  EXPECT_EQ(material.restitution, 0.8);
  EXPECT_EQ(material.sliding_friction, 0.5);
  EXPECT_EQ(material.rolling_friction, 0.1);
  EXPECT_EQ(material.rolling_stiffness, 2.25);
  EXPECT_EQ(material.rolling_viscous_damping, 0.13);
}

TEST(ReadMaterial, RefusesWhatNoGrainHas) {
  EXPECT_CONTAINS(complaint("\"2 GPa\"", "0"), "case.toml:12:18: material.youngs_modulus = 0 is not allowed");
  EXPECT_CONTAINS(complaint("poisson_ratio = 0.25", "poisson_ratio = 0.5"),
                  "material.poisson_ratio = 0.5 is not allowed: it must be at least 0 and below 0.5");
  EXPECT_CONTAINS(complaint("restitution = 0.8", "restitution = 0"),
                  "material.restitution = 0 is not allowed: it must be above 0 and at most 1");
  EXPECT_CONTAINS(complaint("sliding_friction = 0.5", "sliding_friction = -0.5"), "it must be at least 0");
}

TEST(ReadSamples, MayChangeGrainsAndPreparationOfOneSample) {
  const auto samples = samples_of(with("preparation_friction = 0.3", R"(preparation_friction = 0.3
packing.lattice = [6, 6, 6]
preparation.time_step = "5e-6 s"
material.youngs_modulus = "8 GPa")"));
  EXPECT_EQ(samples[1].recipe.packing.counts, (std::array{6, 6, 6}));
  EXPECT_EQ(samples[1].recipe.time_step, 5e-6);
  EXPECT_EQ(samples[1].recipe.material.youngs_modulus, 8e9);
  EXPECT_EQ(samples[1].recipe.material.poisson_ratio, 0.25);
  EXPECT_EQ(samples[0].recipe.packing.counts, (std::array{4, 5, 6}));
  EXPECT_EQ(samples[0].recipe.material.youngs_modulus, 2e9);
  EXPECT_CONTAINS(
      complaint("preparation_friction = 0.3", "preparation_friction = 0.3\npreparation.time_step = \"1 ms\""),
      "sample.isotropic.preparation.time_step = \"1 ms\" is too long");
}

TEST(ReadSamples, TakeMissingKeysFromTheSampleThatOneIsLike) {
  const auto samples = samples_of(with("[sample.isotropic]", R"([sample.small]
like = "isotropic"
packing.lattice = [3, 3, 3]
tolerance = 0.02

[sample.isotropic]
preparation.time_step = "5e-6 s")"));
  const auto& small = *std::find_if(samples.begin(), samples.end(), [](const auto& s) { return s.name == "small"; });
  EXPECT_EQ(small.recipe.packing.counts, (std::array{3, 3, 3}));
  EXPECT_EQ(small.target.tolerance, 0.02);
  EXPECT_EQ(small.target.void_ratio, 0.77);
  EXPECT_EQ(small.recipe.preparation_friction, 0.3);
  EXPECT_EQ(small.recipe.time_step, 5e-6);
  EXPECT_EQ(small.recipe.shear_stress, 0.0);
}

TEST(ReadSamples, TakesEverySampleInTheOrderOfTheFile) {
  const auto samples = samples_of(with());
  ASSERT_EQ(samples.size(), 2U);
  EXPECT_EQ(samples[0].name, "loose");
  EXPECT_EQ(samples[1].name, "isotropic");
  EXPECT_EQ(samples[0].target.void_ratio, 0.79);
  EXPECT_EQ(samples[0].target.tolerance, 0.002);
  EXPECT_EQ(samples[0].target.most_trials, 8);
  const SampleRecipe& recipe = samples[0].recipe;
  EXPECT_EQ(recipe.packing.counts, (std::array{4, 5, 6}));
  EXPECT_EQ(recipe.packing.smallest_diameter, 5e-3);
  EXPECT_EQ(recipe.packing.largest_diameter, 7.5e-3);
  EXPECT_EQ(recipe.packing.seed, 7U);
  EXPECT_EQ(recipe.material.sliding_friction, 0.5);
  EXPECT_EQ(recipe.preparation_friction, 0.4);
  EXPECT_EQ(recipe.drag, 0.06);
  EXPECT_EQ(recipe.time_step, 1e-5);
  EXPECT_EQ(recipe.loose_void_ratio, 1.2);
  EXPECT_EQ(recipe.compaction_rate, 1.0);
  EXPECT_EQ(recipe.servo_rates[0], 0.2);
  EXPECT_EQ(recipe.servo_rates[1], 0.1);
  EXPECT_EQ(recipe.servo_rates[2], 0.05);
  EXPECT_EQ(recipe.servo_interval, 30);
  EXPECT_EQ(recipe.stress_tolerance, 1e-3);
  EXPECT_EQ(recipe.kinetic_tolerance, 1e-8);
  EXPECT_EQ(recipe.mixing_velocity, 0.0);
  EXPECT_EQ(recipe.drag_reference, DragReference::rest);
  EXPECT_TRUE(samples[0].allow_uneven);
  EXPECT_FALSE(samples_of(with("allow_uneven = true", "allow_uneven = false"))[0].allow_uneven);
}

TEST(ReadMaterial, SaysWhyAParameterOfAnotherLawHasNoEffect) {
  const Configuration configuration =
      with("contact_law = \"hertz\"", "contact_law = \"hertz\"\ncharacteristic_velocity = \"1 m/s\"");
  EXPECT_NO_THROW(read_material(configuration));
}

TEST(ReadSamples, TakeTheChoicesThatThePaperLeavesOpen) {
  const SampleSpecification plain = samples_of(with())[0];
  EXPECT_EQ(plain.target.region, VoidRatioRegion::cell);
  EXPECT_EQ(plain.recipe.glue, Glue::one_layer);
  EXPECT_EQ(plain.strain_height, StrainHeight::cell);
  const SampleSpecification decks = samples_of(with("isotropic = false", R"(isotropic = false
void_ratio_of = "probe"
glue = "outer share"
strain_height = "between layers")"))[0];
  EXPECT_EQ(decks.target.region, VoidRatioRegion::probe);
  EXPECT_EQ(decks.recipe.glue, Glue::outer_share);
  EXPECT_EQ(decks.strain_height, StrainHeight::between_layers);
  EXPECT_CONTAINS(complaint("isotropic = false", "isotropic = false\nglue = \"outer\""), "\"outer share\"");
}

TEST(ReadSamples, TakeTheStagesInWhichDragActs) {
  using Stages = std::array<bool, 4>;
  EXPECT_EQ(samples_of(with())[0].recipe.drag_stages, (Stages{true, true, true, true}));
  EXPECT_EQ(samples_of(with("[1, 2, 3, 4]", "[3, 1]"))[0].recipe.drag_stages, (Stages{true, false, true, false}));
  EXPECT_CONTAINS(complaint("[1, 2, 3, 4]", "[1, 5]"), "preparation.drag_stages = 5 is not allowed");
  EXPECT_CONTAINS(complaint("[1, 2, 3, 4]", "[]"), "preparation.drag_stages = [] is empty");
}

TEST(ReadSamples, RefuseToGuessHowAPackingIsMixedAndWhatDragIsRelativeTo) {
  for (const char* key : {"mixing", "drag_reference", "drag_stages", "allow_uneven"}) {
    const std::string name = key;
    EXPECT_CONTAINS(complaint(name + " = ", name + "_was = "), "\"preparation." + name + "\" is missing");
  }
  EXPECT_CONTAINS(complaint("restitution = 0.7", ""), "\"preparation.restitution\" is missing");
  EXPECT_CONTAINS(complaint("restitution = 0.7", "restitution = 1.1"), "preparation.restitution = 1.1 is not allowed");
  EXPECT_CONTAINS(complaint("\"rest\"", "\"moon\""), "\"moon\"");
  EXPECT_CONTAINS(complaint("mixing = \"0 m/s\"", "mixing = \"-1 m/s\""), "preparation.mixing");
  EXPECT_CONTAINS(complaint("mixing = \"0 m/s\"", "mixing = \"50 m/s\""), "overlap");
}

/// Values of the leaves of a recipe, by name.
std::map<std::string, std::string> leaves(const SampleRecipe& recipe) {
  std::map<std::string, std::string> values;
  for_each_leaf(recipe,
                [&](const std::string& name, const auto&, const auto& value) { values[name] = field_text(value); });
  return values;
}

TEST(ReadSamples, ReadEveryFieldOfTheRecipe) {
  // A change of the text for each field; those that no configuration changes have none.
  const std::map<std::string, std::array<const char*, 2>> changes{
      {"packing.lattice", {"[4, 5, 6]", "[4, 5, 7]"}},
      {"packing.smallest_diameter", {"\"5 mm\"", "\"5.1 mm\""}},
      {"packing.largest_diameter", {"\"7.5 mm\"", "\"7.6 mm\""}},
      {"packing.spacing", {}},
      {"packing.jitter", {}},
      {"packing.seed", {"seed = 7", "seed = 8"}},
      {"material.density", {"\"2650 kg/m^3\"", "\"2700 kg/m^3\""}},
      {"material.youngs_modulus", {"\"2 GPa\"", "\"1.9 GPa\""}},
      {"material.poisson_ratio", {"poisson_ratio = 0.25", "poisson_ratio = 0.2"}},
      {"material.restitution", {"restitution = 0.8", "restitution = 0.9"}},
      {"material.contact_law",
       {"contact_law = \"hertz\"", "contact_law = \"linear\"\ncharacteristic_velocity = \"1 m/s\""}},
      {"material.sliding_friction", {"sliding_friction = 0.5", "sliding_friction = 0.4"}},
      {"material.rolling_friction", {"rolling_friction = 0.1", "rolling_friction = 0.2"}},
      {"material.rolling_stiffness", {"rolling_stiffness = 2.25", "rolling_stiffness = 1"}},
      {"material.rolling_viscous_damping", {"rolling_viscous_damping = 0.13", "rolling_viscous_damping = 0"}},
      {"material.torsion_resistance", {"torsion_resistance = false", "torsion_resistance = true"}},
      {"material.normal_force_limited", {"normal_force_limited = false", "normal_force_limited = true"}},
      {"normal_stress", {"\"1500 kg/m^3\"", "\"1600 kg/m^3\""}},
      {"shear_stress", {"isotropic = false", "isotropic = true"}},
      {"preparation_friction", {"preparation_friction = 0.4", "preparation_friction = 0.3"}},
      {"periodic_height", {"isotropic = false", "isotropic = false\nperiodic_height = true"}},
      {"glue", {"isotropic = false", "isotropic = false\nglue = \"outer share\""}},
      {"drag", {"drag = \"0.06 kg/s\"", "drag = \"0.03 kg/s\""}},
      {"drag_reference", {"\"rest\"", "\"uniform compression\""}},
      {"drag_stages", {"[1, 2, 3, 4]", "[2, 3]"}},
      {"restitution", {"restitution = 0.7", "restitution = 0.4"}},
      {"mixing", {"\"0 m/s\"\n", "\"0.4 m/s\"\n"}},
      {"time_step", {"time_step = \"1e-5 s\"", "time_step = \"5e-6 s\""}},
      {"loose_void_ratio", {"loose_void_ratio = 1.2", "loose_void_ratio = 1.3"}},
      {"compaction_rate", {"compaction_rate = \"1 1/s\"", "compaction_rate = \"2 1/s\""}},
      {"servo_rates", {"\"0.1 1/s\"", "\"0.15 1/s\""}},
      {"servo_interval", {"servo_interval = 30", "servo_interval = 20"}},
      {"stress_tolerance", {"stress_tolerance = 1e-3", "stress_tolerance = 1e-2"}},
      {"kinetic_tolerance", {"kinetic_tolerance = 1e-8", "kinetic_tolerance = 1e-9"}},
      {"most_steps", {}},
  };
  const auto before = leaves(samples_of(with())[0].recipe);
  for (const auto& [name, value] : before) {
    ASSERT_TRUE(changes.contains(name)) << name << " is new: say here how a configuration changes it";
    const auto& [from, to] = changes.at(name);
    if (from == nullptr) continue;
    EXPECT_NE(leaves(samples_of(with(from, to))[0].recipe).at(name), value) << name;
  }
  EXPECT_EQ(before.size(), changes.size());
}

TEST(ReadSamples, LeaveOutThoseOfTheBaseThatNoPointNames) {
  const ScratchFolder scratch;
  scratch.write("paper.toml", samples_text);
  const auto samples_with = [&](const std::string& case_file) {
    const Configuration c(Layers{scratch.write("shear/case.toml", "base = '../paper.toml'\n" + case_file), "", {}, {}});
    std::vector<std::string> names;
    for (const SampleSpecification& sample : samples_of(c)) names.push_back(sample.name);
    EXPECT_EQ(samples_in_use(c), names);
    return names;
  };
  EXPECT_EQ(samples_with("[point.a]\nsample = 'isotropic'\n"), std::vector<std::string>{"isotropic"});
  EXPECT_TRUE(samples_with("").empty());
  EXPECT_EQ(samples_with("[sample]\nown = { void_ratio = 0.8, tolerance = 0.1, most_trials = 1, preparation_friction = "
                         "0.5, drag = '0 kg/s', isotropic = true }\n"),
            std::vector<std::string>{"own"});
}

TEST(ReadSamples, BearTheStressesOfTheSlope) {
  const auto samples = samples_of(with());
  // Eqs 8 and 9 by hand, compared to the six digits that are written out: sigma_0 of the paper is 28.34 kPa.
  const double angle = 5.0 * std::numbers::pi / 180.0;
  EXPECT_NEAR(samples[0].recipe.normal_stress, (1000 * 0.2 + 1500 * 1.8) * 9.81 * std::cos(angle), 1e-6);
  EXPECT_NEAR(samples[0].recipe.shear_stress, (2000 * 0.2 + 1500 * 1.8) * 9.81 * std::sin(angle), 1e-6);
  EXPECT_NEAR(samples[0].recipe.normal_stress, 28.34e3, 5.0);
  EXPECT_EQ(samples[1].recipe.normal_stress, samples[0].recipe.normal_stress);
  EXPECT_EQ(samples[1].recipe.shear_stress, 0.0);
}

TEST(ReadSamples, GiveEachReplicateSeedsThatNoSearchOfAnotherReaches) {
  const std::uint64_t first = samples_of(with(), 0)[0].recipe.packing.seed;
  const std::uint64_t second = samples_of(with(), 1)[0].recipe.packing.seed;
  EXPECT_EQ(first, 7U);
  EXPECT_GE(second - first, 100U);  // the most trials that a configuration may allow
}

TEST(ReadSamples, TakeSeedsThatWereFoundBefore) {
  const auto configuration = with("most_trials = 8", "most_trials = 8\nseed_offsets = [4, 9]");
  const auto seed = [&](int replicate) { return samples_of(configuration, replicate).front().recipe.packing.seed; };
  const auto base = samples_of(configuration).back().recipe.packing.seed;  // of a sample without a list
  EXPECT_EQ(seed(0), base + 4);
  EXPECT_EQ(seed(1), base + 9);
  EXPECT_EQ(seed(2), samples_of(configuration, 2).back().recipe.packing.seed);  // beyond the list
}

TEST(ReadSamples, TakeFrictionsThatWereFoundBefore) {
  const auto configuration = with("most_trials = 8", "most_trials = 8\nfound_preparation_frictions = [0.31, 0.29]");
  const auto friction = [&](int replicate) {
    return samples_of(configuration, replicate).front().recipe.preparation_friction;
  };
  EXPECT_EQ(friction(0), 0.31);
  EXPECT_EQ(friction(1), 0.29);
  EXPECT_EQ(friction(2), samples_of(with(), 2)[0].recipe.preparation_friction);  // beyond the list
}

TEST(ReadSamples, DoNotTakeFrictionsThatWereFoundForTheSampleThatOneIsLike) {
  const auto samples = samples_of(with("[sample.isotropic]", R"([sample.small]
like = "isotropic"

[sample.isotropic]
found_preparation_frictions = [0.31])"));
  for (const auto& sample : samples)
    if (sample.name != "loose") EXPECT_EQ(sample.recipe.preparation_friction, sample.name == "small" ? 0.3 : 0.31);
  EXPECT_EQ(samples.size(), 3U);
}

TEST(ReadSamples, RefuseALatticeThatIsNone) {
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[4, 5, 2]"), "case.toml:23:18: packing.lattice = 2 is not allowed");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[4, 5, 2]"), "3");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[0, 5, 6]"), "case.toml:23:12: ");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[4, -5, 6]"), "-5");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[4, 5]"),
                  "packing.lattice = [4, 5] has 2 values, but 3 are needed; give a list of three");
  // A count beyond the range of int would otherwise give another lattice.
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[4, 5, 4294967299]"), "4294967299 is not allowed: it must be between 3 and");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[2000, 2000, 2000]"), "2000 is not allowed");
  EXPECT_CONTAINS(complaint("[4, 5, 6]", "[1000, 1000, 1000]"),
                  "packing.lattice = [1000, 1000, 1000] gives 1000000000 grains, and 10000000 are allowed");
}

TEST(ReadSamples, RefuseSizesThatNoGrainHas) {
  EXPECT_CONTAINS(complaint("\"5 mm\"", "\"0 mm\""),
                  "case.toml:24:21: packing.smallest_diameter = \"0 mm\" is not allowed: it must be above 0 m");
  EXPECT_CONTAINS(complaint("\"5 mm\"", "\"-5 mm\""), "case.toml:24:21: ");
  EXPECT_CONTAINS(complaint("\"7.5 mm\"", "\"4.9 mm\""),
                  "packing.largest_diameter = \"4.9 mm\" is below packing.smallest_diameter, 0.005 m; change one of "
                  "them");
}

TEST(ReadSamples, RefuseAVoidRatioThatNoPackingReaches) {
  EXPECT_CONTAINS(complaint("void_ratio = 0.79", "void_ratio = 0.3"),
                  "case.toml:40:14: sample.loose.void_ratio = 0.3 is not allowed: it must be above 0.55 and below 1");
  EXPECT_CONTAINS(complaint("void_ratio = 0.77", "void_ratio = 1.5"), "case.toml:47:14: sample.isotropic.void_ratio");
  EXPECT_CONTAINS(complaint("tolerance = 0.002", "tolerance = 0"), "case.toml:41:13: sample.loose.tolerance = 0");
  EXPECT_CONTAINS(complaint("most_trials = 8", "most_trials = 0"), "case.toml:42:15: sample.loose.most_trials = 0");
}

TEST(ReadSamples, RefuseAPreparationThatCannotGoOn) {
  EXPECT_CONTAINS(complaint(", \"0.05 1/s\"]", "]"),
                  "preparation.servo_rates = [\"0.2 1/s\", \"0.1 1/s\"] has 2 values, but 3 are needed; give a list");
  EXPECT_CONTAINS(complaint("\"0.1 1/s\"", "\"0 1/s\""), "case.toml:30:27: preparation.servo_rates = \"0 1/s\"");
  EXPECT_CONTAINS(complaint("loose_void_ratio = 1.2", "loose_void_ratio = 0.9"), "above 0.95");
  EXPECT_CONTAINS(complaint("drag = \"0.06 kg/s\"", "drag = \"-0.06 kg/s\""), "case.toml:44:8: sample.loose.drag");
  EXPECT_CONTAINS(complaint("isotropic = false\n", ""), "\"sample.loose.isotropic\" is missing: true or false");
}

TEST(ReadSamples, RefuseAShearStressThatNoPackingBears) {
  // tau_0 is 2650 Pa and sigma_0 28 340 Pa: friction of 0.09 is less than their quotient.
  const std::string message = complaint("sliding_friction = 0.5", "sliding_friction = 0.09");
  EXPECT_CONTAINS(message, "sample loose: shear_stress = 26");
  EXPECT_CONTAINS(message, "smaller than sliding_friction times normal_stress");
}

TEST(ReadGrainTimeStep, AllowsUpTo065RayleighTimesOfTheSmallestGrain) {
  // Rayleigh time by hand: pi R sqrt(rho / G) / (0.1631 nu + 0.8766), R = 2.5 mm, G = E / (2 (1 + nu)) = 0.8 GPa.
  const double rayleigh = std::numbers::pi * 2.5e-3 * std::sqrt(2650 / 0.8e9) / (0.1631 * 0.25 + 0.8766);
  const auto check = [](double time_step) {
    const std::string table = fmt::format("[shear]\ntime_step = \"{} s\"\n", time_step);
    const auto configuration = Configuration::from_text(table, "case.toml");
    read_grain_time_step(configuration, "shear.time_step", 5e-3, Material{});
  };
  EXPECT_NO_THROW(check(0.6499 * rayleigh));
  const std::string message = message_of<ConfigurationError>([&] { check(0.6501 * rayleigh); });
  EXPECT_CONTAINS(message, "case.toml:2:13: shear.time_step = \"1.01");
  EXPECT_CONTAINS(message, "at most 1.01e-05 s, which is 0.65 of the Rayleigh time");
  EXPECT_CONTAINS(message, "choose a smaller step");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { check(-1e-6); }), "it must be above 0 s");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { check(0.0); }), "it must be above 0 s");
  EXPECT_CONTAINS(complaint("time_step = \"1e-5 s\"", "time_step = \"2e-5 s\""),
                  "case.toml:27:13: preparation.time_step = \"2e-5 s\"");
}

}  // namespace
}  // namespace flowslide
