// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/drag_reference.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

TEST(DragReference, EveryNameIsThatOfItsReference) {
  for (const DragReference reference : {DragReference::rest, DragReference::uniform_compression})
    EXPECT_EQ(drag_reference_of(name_of(reference)), reference);
  EXPECT_EQ(drag_reference_names(), (std::vector<std::string>{"rest", "uniform compression"}));
}

TEST(DragReference, RefusesANameThatIsNoneAndSaysWhichAre) {
  try {
    drag_reference_of("moon");
    FAIL() << "there is a reference 'moon'";
  } catch (const std::invalid_argument& error) {
    const std::string text = error.what();
    for (const char* part : {"moon", "rest", "uniform compression"})
      EXPECT_NE(text.find(part), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace flowslide
