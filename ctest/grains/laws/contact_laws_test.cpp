// SPDX-License-Identifier: GPL-2.0-or-later
#include "grains/laws/contact_laws.hpp"

#include <gtest/gtest.h>

#include "grains/material.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(ContactLaws, AreFoundByTheirNames) {
  EXPECT_EQ(contact_law_names().front(), "hertz");
  for (const std::string& name : contact_law_names()) EXPECT_EQ(name_of(contact_law_of(name)), name);
}

TEST(ContactLaws, AnotherNameIsRefusedWithThoseAllowed) {
  const std::string message = message_of<std::invalid_argument>([] { contact_law_of("hertzian"); });
  EXPECT_CONTAINS(message, "\"hertzian\" is not known; choose one of: hertz");
}

TEST(ContactLaws, UseTheParametersOfTheirPartsAndOfTheGrains) {
  EXPECT_TRUE(uses_parameter(ContactLaw::hertz, "rolling_friction"));
  EXPECT_TRUE(uses_parameter(ContactLaw::hertz, "density"));
}

/// A rolling part that shares its only parameter with Epsd3.
struct OtherRolling {
  using Parameters = laws::List<laws::RollingFriction>;
};

TEST(ContactLaws, PartsMayShareAParameter) {
  using Both = laws::ParametersOf<laws::List<laws::Epsd3, OtherRolling>>;
  EXPECT_EQ(std::tuple_size_v<decltype(Both::fields())>, 4u);
  EXPECT_EQ(
      text_of_fields(Both{}),
      "rolling_friction = 0.1\nrolling_stiffness = 2.25\nrolling_viscous_damping = 0.13\ntorsion_resistance = false\n");
  EXPECT_TRUE(laws::has_parameter<OtherRolling>("rolling_friction"));
  EXPECT_FALSE(laws::has_parameter<OtherRolling>("rolling_stiffness"));
}

TEST(ContactLaws, OfTheSamePartsHaveDifferentNames) {
  using laws::Epsd3, laws::Hertz, laws::Law, laws::List, laws::Sliding;
  using First = Law<"first", Hertz, Sliding, Epsd3>;
  EXPECT_STREQ(First::name, "first");
  EXPECT_TRUE(laws::have_different_names(List<First, Law<"second", Hertz, Sliding, Epsd3>>{}));
  EXPECT_FALSE(laws::have_different_names(List<First, Law<"first", Hertz, Sliding, OtherRolling>>{}));
}

TEST(ContactLaws, TheTextOfAMaterialNamesItsLaw) {
  EXPECT_NE(text_of_fields(Material{}).find("contact_law = hertz\n"), std::string::npos);
}

}  // namespace
}  // namespace flowslide
