// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/remarks.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

constexpr const char* text = R"(replicates = 4
[elastic]
void_ratio = 0.79
[critical_state]
void_ratio = 0.79
[sample.loose]
seed_offsets = [3, 7]
)";

class Remarks : public testing::Test {
 protected:
  std::vector<std::string> of(const std::string& users, const std::string& engine) const {
    Layers layers{.case_file = scratch_.write("case.toml", text), .scale = {}, .user_file = {}, .overrides = {}};
    layers.user_file = scratch_.write("mine.toml", users);
    const Configuration configuration(layers);
    const std::string before = configuration.resolved();
    const auto remarks = remarks_on(configuration, engine);
    EXPECT_EQ(configuration.resolved(), before);
    return remarks;
  }
  std::string one_of(const std::string& users, const std::string& engine) const {
    const auto remarks = of(users, engine);
    EXPECT_EQ(remarks.size(), 1U);
    return remarks.empty() ? "" : remarks.front();
  }

  ScratchFolder scratch_;
};

TEST_F(Remarks, AreNotAboutTheValuesOfTheCase) {
  for (const char* engine : {"native", "elastic", "critical_state"}) EXPECT_TRUE(of("", engine).empty()) << engine;
}

TEST_F(Remarks, NameValuesOfASampleThatTheEngineIsNot) {
  const std::string users = "[elastic]\nvoid_ratio = 0.8\nshear_modulus = '3 MPa'\n";
  EXPECT_TRUE(of(users, "elastic").empty());
  const std::string remark = one_of(users, "critical_state");
  EXPECT_CONTAINS(remark, "mine.toml:2:1: elastic.void_ratio = 0.8; ");
  EXPECT_CONTAINS(remark,
                  "mine.toml:3:1: elastic.shear_modulus = '3 MPa': not used: engine = \"critical_state\" does not "
                  "read [elastic]; engine = \"elastic\" does");
  EXPECT_EQ(of(users + "[critical_state]\nvoid_ratio = 0.8\n", "native").size(), 2U);
}

TEST_F(Remarks, TellTheSeedsBeyondAShortList) {
  const std::string users = "[sample.loose]\nseed_offsets = [5, 6]\n";
  EXPECT_CONTAINS(
      one_of(users, "native"),
      "mine.toml:2:1: sample.loose.seed_offsets = [5, 6]: 2 numbers for 4 replicates: replicate 3 gets 2000, "
      "each further one 1000 more; give one for each replicate to choose them");
  EXPECT_CONTAINS(one_of("[sample.mine]\nlike = 'loose'\nseed_offsets = 5\n", "native"),
                  ": one number for 4 replicates");
  EXPECT_EQ(of(users + "[sample.mine]\nlike = 'loose'\n", "native").size(), 1U);
  EXPECT_TRUE(of(users, "elastic").empty());
  EXPECT_TRUE(of("replicates = 2\n" + users, "native").empty());
}

}  // namespace
}  // namespace flowslide
