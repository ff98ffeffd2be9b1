// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/replicates.hpp"

#include "configuration/error.hpp"
#include "record/result_file.hpp"
#include "record/temporary_folder.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

SampleSpecification sample(std::uint64_t seed, double friction = 0.5, const std::string& name = "loose") {
  SampleSpecification specification{name, {}, {}};
  specification.recipe.packing.seed = seed;
  specification.recipe.preparation_friction = friction;
  return specification;
}

Provenance result(const std::string& point, int replicate, const std::string& of_sample) {
  Provenance provenance;
  provenance.point = point;
  provenance.replicate = replicate;
  provenance.sample = of_sample;
  return provenance;
}

TEST(Replicates, BeginWithRecipesOfTheirOwn) {
  const auto configuration = Configuration::from_text("[sample.loose]\n[sample.dense]\n", "case.toml");
  EXPECT_NO_THROW(refuse_equal_recipes(configuration, {{sample(1)}, {sample(2)}, {sample(1, 0.6)}}));
  EXPECT_NO_THROW(refuse_equal_recipes(configuration, {{sample(1), sample(1, 0.5, "dense")}, {sample(2)}}));
  const std::string message = message_of<ConfigurationError>([&] {
    refuse_equal_recipes(configuration, {{sample(1)}, {sample(2)}, {sample(1)}});
  });
  EXPECT_CONTAINS(message, "[sample.loose]: replicates 1 and 3 of the sample \"loose\" are the same");
  EXPECT_CONTAINS(message, "give sample.loose.seed_offsets one number for each replicate, all of them different");
}

TEST(Replicates, AreRefusedWhenASearchComesToTheSampleOfAnother) {
  EXPECT_NO_THROW(refuse_equal_samples({result("RD", 0, "loose a"), result("RI", 0, "loose a"),
                                        result("RD_r2", 1, "loose b"), result("other", 1, "dense a")}));
  EXPECT_NO_THROW(refuse_equal_samples({result("RD", 0, "loose"), result("RD_r2", 1, "loose")}));  // not of grains
  const std::string message = message_of<ConfigurationError>([] {
    refuse_equal_samples({result("RD", 0, "loose a"), result("RI_r2", 1, "loose a")});
  });
  EXPECT_CONTAINS(message, "RD and RI_r2 are no replicates: they have the same sample \"loose\"");
  EXPECT_CONTAINS(message, "set sample.loose.seed_offsets");
}

TEST(Replicates, AreRefusedBeforeARunIsSpentOnThem) {
  const TemporaryFolder folder;
  Result there;
  there.provenance = result("RD", 0, "loose a");
  there.configuration_hash = "this";
  write_result(folder / "RD.h5", there);
  const std::vector<std::string> points{"RD", "RD_r2", "not_run"};
  EXPECT_THROW(refuse_sample_of_others(result("RD_r2", 1, "loose a"), "this", folder.path(), points),
               ConfigurationError);
  EXPECT_NO_THROW(refuse_sample_of_others(result("RD_r2", 1, "loose b"), "this", folder.path(), points));
  EXPECT_NO_THROW(refuse_sample_of_others(result("RD_r2", 1, "loose a"), "another", folder.path(), points));
  EXPECT_NO_THROW(refuse_sample_of_others(result("RD", 1, "loose a"), "this", folder.path(), points));  // its own file
}

}  // namespace
}  // namespace flowslide
