// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_shear_test.hpp"

#include <fmt/format.h>

namespace flowslide {

ShearTest read_shear_test(const Configuration& configuration, const TableNames& tables,
                              const SampleRecipe& recipe) {
  const Tables table(configuration, tables);
  ShearTest test;
  if (table.has("inertial_number")) {
    test.inertial_number = table.number("inertial_number", Range::positive());
    test = for_sample(test, recipe, lattice_packing(recipe.packing).mean_diameter());
    if (table.has("shear_rate"))
      table.refuse("inertial_number", fmt::format("conflicts with \"{}\", which is given too", table.key("shear_rate")),
                   "leave one of them out");
  } else {
    test.shear_rate = table.positive("shear_rate", dimension::rate);
  }
  test.final_strain = table.number("final_strain", Range::above_up_to(0.0, 100.0));
  if (table.has("end_normal_stress")) test.end_normal_stress = table.positive("end_normal_stress", dimension::stress);
  test.rows = static_cast<int>(table.integer("rows", Range::between(10, 100000)));
  return test;
}

}  // namespace flowslide
