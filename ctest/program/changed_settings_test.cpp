// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/changed_settings.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

using Texts = std::vector<std::string>;

class ChangedSettings : public testing::Test {
 protected:
  /// What differs when these are given with --set and in a file.
  Texts changed(const std::vector<std::pair<std::string, std::string>>& settings, const std::string& user = "") {
    Layers layers{.case_file = scratch_.write("case.toml", R"(engine = "native"
seed = 1
replicates = 3
coupling.local_time_step = "1e-5 s"
[loading]
amplitude = "3 kPa"
[rows]
row_interval = "4 ms"
[profiles]
strains = [0.1, 0.3]
[point.RD]
scheme = "RD"
[scale.quick]
loading.amplitude = "2 kPa"
[scale.paper]
)"),
                  .scale = "paper",
                  .user_file = {},
                  .overrides = {}};
    if (!user.empty()) layers.user_file = scratch_.write("user.toml", user);
    for (const auto& [key, value] : settings) layers.overrides.push_back({key, value, "--set " + key});
    const Configuration configuration(layers);
    for (const char* key : {"engine"}) configuration.text(key);
    for (const char* key : {"seed", "replicates"}) configuration.integer(key);
    configuration.quantity("loading.amplitude", dimension::stress);
    configuration.quantity("rows.row_interval", dimension::time);
    configuration.quantity("coupling.local_time_step", dimension::time);
    configuration.numbers("profiles.strains");
    for (const std::string& name : configuration.subtables("point")) {
      configuration.text("point." + name + ".scheme");
      if (const std::string key = "point." + name + ".k"; configuration.has(key)) configuration.number(key);
    }
    return changed_settings(configuration);
  }
  ScratchFolder scratch_;
};

TEST_F(ChangedSettings, AreNoneOfTheCaseItself) {
  EXPECT_EQ(changed({}), Texts{});
  EXPECT_EQ(changed({{"loading.amplitude", "3 kPa"}, {"profiles.strains", "[0.1, 0.3]"}}), Texts{});  // as they are
}

TEST_F(ChangedSettings, AreNamedWithBothValues) {
  EXPECT_EQ(changed({{"loading.amplitude", "2 kPa"}}), Texts{"loading.amplitude = \"2 kPa\", not \"3 kPa\""});
  EXPECT_EQ(changed({}, "profiles.strains = [0.1, 0.2]"), Texts{"profiles.strains = [0.1, 0.2], not [0.1, 0.3]"});
  EXPECT_EQ(changed({{"point.RD.k", "1"}}), Texts{"point.RD.k = 1.0, which the case does not set"});
}

TEST_F(ChangedSettings, DoNotCountHowARunIsComputed) {
  EXPECT_EQ(changed({{"engine", "elastic"},
                     {"seed", "7"},
                     {"replicates", "1"},
                     {"rows.row_interval", "1 s"},
                     {"coupling.local_time_step", "5e-7 s"}}),
            Texts{});
}

TEST_F(ChangedSettings, DoNotCountRunsThatAStudyAdds) {
  EXPECT_EQ(changed({}, "[point.mine]\nscheme = 'RI'\nk = 2e-5\n"), Texts{});
  EXPECT_EQ(changed({}, "[point.RD]\nscheme = 'RI'\n"), Texts{"point.RD.scheme = \"RI\", not \"RD\""});
}

}  // namespace
}  // namespace flowslide
