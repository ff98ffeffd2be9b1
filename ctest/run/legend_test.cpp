// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/legend.hpp"

#include "support/messages.hpp"

namespace flowslide {
namespace {

std::string written(const Legend& legend) {
  const ScratchFolder scratch;
  const auto folder = OutputFolder::open(scratch.path() / "out", "fig12");
  legend.write(folder);
  return content_of(folder.file("legend.txt"));
}

TEST(Legend, HasALineForEachCurve) {
  Legend legend;
  legend.add("RD_3kPa", "{/:Italic A} = 3 kPa");
  legend.add("RI_3kPa", "rate-independent");
  EXPECT_EQ(written(legend), "# point\tlabel\nRD_3kPa\t{/:Italic A} = 3 kPa\nRI_3kPa\trate-independent\n");
}

TEST(Legend, WithoutLabelsIsNoEmptyFileWhichScriptsTakeForAMissingTable) {
  EXPECT_EQ(written(Legend()), "# point\tlabel\n");
}

}  // namespace
}  // namespace flowslide
