// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_closed_form_sample.hpp"

#include "configuration/error.hpp"
#include "sample/closed_form.hpp"
#include "support/messages.hpp"

namespace flowslide::read_closed_form_sample_test {
namespace {

constexpr const char* text = R"([elastic]
shear_modulus = "15 MPa"
oedometric_modulus = "40 MPa"
viscosity = "2 Pa s"
void_ratio = 0.77
[critical_state]
critical_friction = 0.4
critical_void_ratio = 0.77
critical_slope = 0.01
reference_stress = "28.34 kPa"
shear_stiffness = 500
oedometric_stiffness = 1400
hardening = 0.5
peak_exponent = 1.1
dilatancy = 0.3
dilatancy_exponent = 3.5
void_ratio = 0.83
)";

std::unique_ptr<Sample> sample_of(const std::string& name, const std::string& from = "", const std::string& to = "",
                                  const SlopeProperties& slope = {}) {
  std::string changed = text;
  changed.replace(changed.find(from), from.size(), to);
  const auto configuration = Configuration::from_text(changed, "case.toml");
  return read_closed_form_sample(configuration, name, slope);
}

TEST(ReadClosedFormSample, IsInBalanceWithTheSlope) {
  for (const std::string& name : closed_form_sample_names()) {
    const auto sample = sample_of(name);
    EXPECT_NEAR(sample->stress().shear, 2650.4933, 5e-5) << name;  // eqs 8 and 9 to the digits written
    EXPECT_NEAR(sample->stress().normal, 28340.7430, 5e-5) << name;
  }
}

TEST(ReadClosedFormSample, TakesItsValues) {
  const auto elastic = sample_of("elastic");
  EXPECT_NEAR(elastic->strain({{1.0, 2.0}, 10, 1e-6}).shear, 2650.4933 + 15e6 * 1e-5 + 2.0, 5e-5);
  EXPECT_NEAR(elastic->stress().normal, 28340.7430 + 40e6 * 2e-5, 5e-5);
  const auto sand = sample_of("critical_state");
  EXPECT_EQ(sand->void_ratio(), 0.83);
  sand->strain({{1.0, 0.0}, 1000, 1e-3});
  EXPECT_LT(sand->stress().normal, 300.0);  // so loose that it liquefies
  const auto dense = sample_of("critical_state", "void_ratio = 0.83", "void_ratio = 0.755");
  dense->strain({{1.0, 0.0}, 1000, 1e-3});
  EXPECT_GT(dense->stress().normal, 28341.0);
}

TEST(ReadClosedFormSample, RefusesValuesOutOfRangeAndASlopeThatItCannotBear) {
  const auto complaint = [](const std::string& name, const std::string& from, const std::string& to) {
    return message_of<ConfigurationError>([&] { sample_of(name, from, to); });
  };
  EXPECT_CONTAINS(complaint("elastic", "\"15 MPa\"", "\"0 MPa\""), "case.toml:2:17: elastic.shear_modulus");
  EXPECT_CONTAINS(complaint("elastic", "\"2 Pa s\"", "\"-2 Pa s\""), "at least 0");
  EXPECT_CONTAINS(complaint("critical_state", "hardening = 0.5", "hardening = 0"), "critical_state.hardening = 0");
  EXPECT_CONTAINS(complaint("critical_state", "critical_friction = 0.4", "critical_friction = 0.09"),
                  "[critical_state]: shear stress over normal stress of the critical-state sample is 0.0935");
  EXPECT_CONTAINS(complaint("rubber", "", ""), "\"rubber\" is no closed-form sample");
}

}  // namespace
}  // namespace flowslide::read_closed_form_sample_test
