// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/versions.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "dem/make_engine.hpp"
#include "sample/closed_form.hpp"
#include "sample/void_ratio_search.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {
namespace {

TEST(EngineVersion, IsThatOfItsSources) {
  EXPECT_EQ(engine_version("native"), make_engine("native", "/dev/null")->version());
  EXPECT_EQ(engine_version("elastic"), closed_form_version("elastic"));
  EXPECT_THROW(engine_version("rubber"), std::invalid_argument);
}

TEST(VersionsOf, HoldRunEnginePreparationAndSearch) {
  const RunVersions grains = versions_of({"native-mixed", "native", {}});
  EXPECT_EQ(grains.engine, engine_version("native-mixed"));
  // The kernel and the procedure of the preparation are in it, each by its hash.
  EXPECT_EQ(grains.preparation, preparation_identity("native", engine_version("native")));
  EXPECT_EQ(grains.search, search_version());
  EXPECT_EQ(grains.run.size(), 16U);
  EXPECT_EQ(grains.run, versions_of({"elastic", "", {}}).run);
}

TEST(VersionsOf, HoldNothingOfWhatARunHasNot) {
  const RunVersions closed_form = versions_of({"critical_state", "", {}});
  EXPECT_EQ(closed_form.engine, closed_form_version("critical_state"));
  EXPECT_EQ(closed_form.preparation + closed_form.search, "");
  EXPECT_EQ(versions_of({}).engine, "");
}

}  // namespace
}  // namespace flowslide
