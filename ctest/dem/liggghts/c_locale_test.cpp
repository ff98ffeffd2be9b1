// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/c_locale.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "dem/liggghts/liggghts_engine.hpp"
#include "support/comma_locale.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {
namespace {

TEST(CLocale, HasADecimalPointForAsLongAsItLives) {
  const CommaLocale host;
  if (!host.works()) GTEST_SKIP() << "this C library does not take the locale of the test";
  ASSERT_EQ(std::atof("0.5"), 0.0);
  {
    const CLocale locale;
    EXPECT_EQ(std::atof("0.5"), 0.5);
    {
      const CLocale inner;
      EXPECT_EQ(std::atof("0.5"), 0.5);
    }
    EXPECT_EQ(std::atof("0.5"), 0.5);
    double elsewhere = -1.0;
    std::thread([&] { elsewhere = std::atof("0.5"); }).join();
    EXPECT_EQ(elsewhere, 0.0);
  }
  EXPECT_EQ(std::atof("0.5"), 0.0);
}

TEST(LiggghtsEngine, ComputesTheSameInAHostWithADecimalComma) {
  const EngineSettings settings{Material{}, 2e-6, 0.1};
  const auto stress = [&] {
    LiggghtsEngine engine(testing::TempDir() + "locale.log");
    engine.load(touching_lattice(), settings);
    engine.run(20);
    EngineSettings other = settings;
    other.material.sliding_friction = 0.25;
    engine.set(other);
    engine.run(20);
    return engine.cell_stress();
  };
  const CellStress expected = stress();
  const CommaLocale host;
  if (!host.works()) GTEST_SKIP() << "this C library does not take the locale of the test";
  const CellStress found = stress();
  EXPECT_EQ(found.normal, expected.normal);
  EXPECT_EQ(found.shear, expected.shear);
  EXPECT_EQ(found.lateral_x, expected.lateral_x);
}

}  // namespace
}  // namespace flowslide
