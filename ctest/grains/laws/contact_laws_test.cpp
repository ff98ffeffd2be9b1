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

TEST(ContactLaws, TheTextOfAMaterialNamesItsLaw) {
  EXPECT_NE(text_of_fields(Material{}).find("contact_law = hertz\n"), std::string::npos);
}

}  // namespace
}  // namespace flowslide
