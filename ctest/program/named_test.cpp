// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/named.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

struct Scene {
  std::string name;
};

TEST(Named, FindsAnElementAndNamesOneThatIsMissing) {
  const std::vector<Scene> scenes{{"first"}, {"second"}};
  EXPECT_EQ(&named(scenes, "scene", "second", &Scene::name), &scenes[1]);
  EXPECT_EQ(message_of<std::out_of_range>([&] { named(scenes, "scene", "third", &Scene::name); }),
            "there is no scene \"third\"");
}

}  // namespace
}  // namespace flowslide
