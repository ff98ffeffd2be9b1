// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/error.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(AsWrittenByUser, IsAnErrorOfTheConfigurationAtItsPlace) {
  EXPECT_EQ(as_written_by_user("[slope]", [] { return 3; }), 3);
  const auto fail = [](const std::string& place) {
    return message_of<ConfigurationError>(
        [&] { as_written_by_user(place, [] { throw std::invalid_argument("too steep"); }); });
  };
  EXPECT_EQ(fail("[slope]"), "[slope]: too steep");
  EXPECT_EQ(fail(""), "too steep");
  EXPECT_THROW(as_written_by_user("", [] { throw std::out_of_range("a"); }), std::out_of_range);
}

}  // namespace
}  // namespace flowslide
