// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/vocabulary.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(Vocabulary, SaysWhichRunsUseAKey) {
  const auto complaint_about = [](const std::string& toml) {
    const auto configuration = Configuration::from_text(toml, "user.toml");
    describe_vocabulary(configuration);
    return message_of<ConfigurationError>([&] { configuration.reject_unknown(); });
  };
  EXPECT_CONTAINS(complaint_about("[loading]\nrate = 1\n"), "it belongs to slides, which are runs with a scheme");
  EXPECT_CONTAINS(complaint_about("[shear_test]\nrows = 1\n"),
                  "it belongs to element tests, which are runs with final_strain");
  EXPECT_CONTAINS(complaint_about("[elastic]\nviscosity = 1\n"), "it belongs to slides with --engine elastic");
  EXPECT_CONTAINS(complaint_about("[packing]\nshape = 1\n"), "unknown table \"packing\"");
}

}  // namespace
}  // namespace flowslide
