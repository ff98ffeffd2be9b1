// SPDX-License-Identifier: GPL-2.0-or-later
#include "scene_context.hpp"

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

SceneSettings read(const std::vector<Override>& overrides = {}) {
  return SceneSettings::read(Configuration({FLOWSLIDE_CASE_FOLDER "/case.toml", "quick", {}, overrides}));
}

TEST(SceneSettings, TakesEachSampleByItsName) {
  const SceneSettings settings =
      read({{"sample.loose.preparation_friction", "0.51", ""}, {"sample.dense.preparation_friction", "0.11", ""}});
  EXPECT_EQ(settings.loose.preparation_friction, 0.51);
  EXPECT_EQ(settings.dense.preparation_friction, 0.11);
}

TEST(SceneSettings, RefusesASampleOfAnotherName) {
  std::vector<Override> overrides;
  for (const char* key : {"void_ratio=0.7", "tolerance=0.1", "most_trials=1", "preparation_friction=0.1",
                          "drag=\"0.03 kg/s\"", "isotropic=false"}) {
    const std::string text = key;
    const std::size_t equals = text.find('=');
    overrides.push_back(
        {"sample.dens." + text.substr(0, equals), text.substr(equals + 1), "--set sample.dens." + text});
  }
  EXPECT_CONTAINS(
      message_of<ConfigurationError>([&] { read(overrides); }),
      "--set sample.dens.void_ratio=0.7: the value is not a sample of these scenes; remove it, or name it ");
}

}  // namespace
}  // namespace flowslide
