// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/closed_form.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace flowslide {
namespace {

TEST(ClosedFormSamples, HaveAVersionEach) {
  EXPECT_NE(closed_form_version("elastic"), closed_form_version("critical_state"));
  EXPECT_THROW(closed_form_version("native"), std::invalid_argument);
  for (const std::string& name : closed_form_sample_names()) EXPECT_TRUE(is_closed_form(name));
  EXPECT_FALSE(is_closed_form("native"));
}

}  // namespace
}  // namespace flowslide
