// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr const char* base = R"([slope]
angle = "5 deg"
[loading]
history = "pulse"
amplitude = "3 kPa"
[coupling]
time_step = "1e-4 s"
[scheme.RI]
smallest_rate = "3 1/s"
[preparation]
time_step = "7e-6 s"
drag_stages = [1, 2]
[critical_state]
void_ratio = 0.79
[elastic]
void_ratio = 0.79
[sample.mine]
like = "loose"
drag = "0.1 kg/s"
[sample.loose]
void_ratio = 0.8
)";

Sweep sweep_of_text(const std::string& sweep, const std::string& engine = "native") {
  return read_sweep(Configuration::from_text(base + ("[sweep]\n" + sweep), "mine.toml"), engine, "mine");
}

std::string refusal_of(const std::string& sweep, const std::string& engine = "native") {
  return message_of<ConfigurationError>([&] { sweep_of_text(sweep, engine); });
}

TEST(Sweep, ReadsQuantitiesInOrderWithTheirUnit) {
  const Sweep sweep = sweep_of_text("angle = ['4.5 deg', '3 deg', 0]\n");
  EXPECT_EQ(sweep.key, "sweep.angle");
  EXPECT_EQ(sweep.target("RD_3deg", "mine"), "slope.angle");
  EXPECT_EQ(sweep.axis_label(), "angle (deg)");
  EXPECT_EQ(sweep.si_unit, "rad");
  ASSERT_EQ(sweep.values.size(), 3U);
  EXPECT_EQ(sweep.values[0].item, 2U);
  EXPECT_EQ(sweep.values[1].file_name, "3deg");
  EXPECT_EQ(sweep.values[2].file_name, "4p5deg");
  EXPECT_EQ(sweep.values[2].item, 0U);
  EXPECT_EQ(sweep.values[2].as_written, 4.5);
  EXPECT_DOUBLE_EQ(sweep.values[2].number, 4.5 * 0.017453292519943295);
}

TEST(Sweep, TakesTheSiUnitForAListWithSeveralUnits) {
  const Sweep sweep = sweep_of_text("amplitude = ['3 kPa', '500 Pa']\n");
  EXPECT_EQ(sweep.axis_label(), "amplitude (Pa)");
  EXPECT_EQ(sweep.values[0].as_written, 500.0);
  EXPECT_EQ(sweep.values[1].as_written, 3000.0);
}

TEST(Sweep, ReadsTextsInTheirOrder) {
  const Sweep sweep = sweep_of_text("sample = ['mine', 'loose']\n");
  EXPECT_FALSE(sweep.is_of_numbers);
  EXPECT_EQ(sweep.target("RD_mine", "mine"), "point.RD_mine.sample");
  EXPECT_EQ(sweep.axis_label(), "sample");
  EXPECT_EQ(sweep.values[0].text, "mine");
  EXPECT_EQ(sweep.values[1].number, 2.0);
}

TEST(Sweep, FindsTheTableOfAKey) {
  EXPECT_EQ(sweep_of_text("drag = ['0.1 kg/s']\n").target("RD", "mine"), "sample.mine.drag");
  EXPECT_EQ(sweep_of_text("void_ratio = [0.8]\n").target("RD", "mine"), "sample.mine.void_ratio");
  EXPECT_EQ(sweep_of_text("smallest_rate = ['1 1/s']\n").target("RI_1", "mine"), "point.RI_1.coupling.smallest_rate");
  EXPECT_EQ(sweep_of_text("coupling.time_step = ['1e-4 s']\n").table, "coupling");
  EXPECT_EQ(sweep_of_text("void_ratio = [0.8]\n", "critical_state").target("RD", "mine"), "critical_state.void_ratio");
}

TEST(Sweep, RefusesOtherKeysAndNamesTheAllowedOnes) {
  const std::string message = refusal_of("angel = ['3 deg']\n");
  EXPECT_CONTAINS(message, "mine.toml:23:9: sweep.angel = ['3 deg'] cannot be swept; did you mean \"angle\"? allowed: "
                           "sample, or a key with one value of [slope] (angle), [loading] (");
  EXPECT_CONTAINS(message, "[sample] (drag, void_ratio)");
  EXPECT_CONTAINS_NOT(message, "drag_stages");
  EXPECT_CONTAINS(refusal_of("A = ['1 kPa']\n"), "did you mean \"amplitude\"?");
  EXPECT_CONTAINS(refusal_of("scheme = ['RD', 'RI']\n"), "give several schemes by study.scheme; allowed: ");
  EXPECT_CONTAINS(refusal_of("drag = ['1 kg/s']\n", "critical_state"), "[critical_state] (");
  EXPECT_CONTAINS(refusal_of("sample = ['mine']\n", "elastic"), "cannot be swept");
  EXPECT_CONTAINS(refusal_of("time_step = ['1e-4 s']\n"),
                  "may mean a key of [coupling] or [preparation]; write sweep.coupling.time_step or "
                  "sweep.preparation.time_step");
  EXPECT_CONTAINS(refusal_of("angle = ['3 deg']\namplitude = ['1 kPa']\n"), "is the second key of [sweep]");
}

TEST(Sweep, RefusesAKeyThatHasNoEffectAndSaysWhy) {
  EXPECT_CONTAINS(
      refusal_of("void_ratio = [0.7, 0.8]\n", "elastic"),
      "sweep.void_ratio = [0.7, 0.8] has no effect: the stresses of the elastic sample do not depend on it; "
      "sweep another key");
  EXPECT_CONTAINS(
      refusal_of("elastic.shear_modulus = ['3 MPa']\n", "critical_state"),
      "has no effect: engine = \"critical_state\" does not use [elastic], engine = \"elastic\" does; choose "
      "that engine, or sweep another key");
  EXPECT_CONTAINS(refusal_of("shear_modulus = ['3 MPa']\n"), "engine = \"native\" does not use [elastic]");
  EXPECT_CONTAINS(refusal_of("critical_friction = [0.5]\n"), "does not use [critical_state]");
  EXPECT_CONTAINS(refusal_of("coupling.shear_modulus = ['3 MPa']\n", "elastic"),
                  "has no effect: it is only a bound for the limit of dt_G");
  EXPECT_EQ(sweep_of_text("shear_modulus = ['3 MPa']\n", "elastic").table, "elastic");
}

TEST(Sweep, RefusesAValueThatOccursTwice) {
  EXPECT_CONTAINS(refusal_of("amplitude = ['3 kPa', '3000 Pa']\n"), "gives \"3000 Pa\" twice");
  EXPECT_CONTAINS(refusal_of("sample = ['mine', 'mine']\n"), "gives \"mine\" twice");
  EXPECT_CONTAINS(refusal_of("angle = []\n"), "is empty");
}

TEST(Sweep, IsAbsentWithoutItsTable) {
  EXPECT_FALSE(read_sweep(Configuration::from_text(base), "native", "mine").exists());
}

}  // namespace
}  // namespace flowslide
