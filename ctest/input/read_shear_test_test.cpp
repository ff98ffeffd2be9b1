// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_shear_test.hpp"

#include "configuration/error.hpp"
#include "grains/measures.hpp"
#include "grains/packing.hpp"
#include "support/messages.hpp"

namespace flowslide::read_shear_test_test {
namespace {

ShearTest read(const std::string& own) {
  const auto configuration = Configuration::from_text("[all]\nrows = 100\n[own]\n" + own, "case.toml");
  SampleRecipe recipe;
  recipe.normal_stress = 28e3;
  return read_shear_test(configuration, {"own", "all"}, recipe);
}

std::string complaint(const std::string& own) {
  return message_of<ConfigurationError>([&] { read(own); });
}

TEST(ReadShearTest, TakesARate) {
  const ShearTest test = read("shear_rate = \"0.06 1/s\"\nfinal_strain = \"5 %\"\n");
  EXPECT_EQ(test.shear_rate, 0.06);
  EXPECT_EQ(test.final_strain, 0.05);
  EXPECT_EQ(test.rows, 100);
}

TEST(ReadShearTest, TakesAnInertialNumberAtTheInitialStress) {
  const ShearTest test = read("inertial_number = 1e-2\nfinal_strain = 0.05\nrows = 20\n");
  const double mean_diameter = lattice_packing(SampleRecipe{}.packing).mean_diameter();
  EXPECT_NEAR(inertial_number(test.shear_rate, mean_diameter, Material{}.density, 28e3), 1e-2, 1e-14);
  EXPECT_EQ(test.rows, 20);
}

TEST(ReadShearTest, RefusesBothRatesNoneAndValuesOutOfRange) {
  EXPECT_CONTAINS(complaint("shear_rate = \"1 1/s\"\ninertial_number = 1e-2\nfinal_strain = 1\n"),
                  "leave one of them out");
  EXPECT_CONTAINS(complaint("final_strain = 1\n"), "shear_rate");
  EXPECT_CONTAINS(complaint("shear_rate = 0\nfinal_strain = 1\n"), "own.shear_rate = 0 is not allowed");
  EXPECT_CONTAINS(complaint("inertial_number = -1\nfinal_strain = 1\n"), "it must be above 0");
  EXPECT_CONTAINS(complaint("shear_rate = \"1 1/s\"\nfinal_strain = 0\n"), "own.final_strain");
  EXPECT_CONTAINS(complaint("shear_rate = \"1 1/s\"\nfinal_strain = 1\nrows = 5\n"),
                  "it must be between 10 and 100000");
}

}  // namespace
}  // namespace flowslide::read_shear_test_test
