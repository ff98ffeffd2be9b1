// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/preliminary_results.hpp"

#include "process/exit_code.hpp"
#include "record/gnuplot_table.hpp"
#include "record/same_bits.hpp"
#include "run/example_checkpoint.hpp"
#include "run/point_checkpoints.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(SoFar, HasWhatIsCompleteAndWhatIsKept) {
  const ScratchFolder scratch;
  const OutputFolder output = OutputFolder::open(scratch.path() / "out", "fig12");
  const OutputFolder copy = OutputFolder::open(scratch.path() / "copy", "fig12");
  const RunIdentity identity{"fig12", "R", {}, "seed = 7\n"};
  const std::map<std::string, RunIdentity> points{{"RD", identity}, {"RI", identity}, {"RX", identity}};
  EXPECT_THROW(copy_preliminary_results(output, copy, points), Refused);

  Result result = example_result();
  identity.stamp(result);
  write_result(output.file("RD.h5"), result);
  write_table(output.file("RD.dat"), table_of(result));
  Checkpoint checkpoint = example_checkpoint();
  identity.stamp(checkpoint.partial_result);
  output.checkpoints("RI").put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
  for (int time = 0; time < 2; ++time)  // again and again
    EXPECT_EQ(copy_preliminary_results(output, copy, points),
              "RD: complete\nRI: so far at " + place_of(example_checkpoint()) + "\nRX: nothing yet\n");
  expect_same_bits(read_result(copy.file("RI.h5")).series, example_checkpoint().partial_result.series);
  expect_same_bits(read_table(copy.file("RI.dat")).series, example_checkpoint().partial_result.series);
  expect_same_bits(read_table(copy.file("RI_profiles.dat")).series, example_checkpoint().slide->complete_profiles);
  EXPECT_EQ(content_of(copy.file("RD.dat")), content_of(output.file("RD.dat")));
  EXPECT_FALSE(std::filesystem::exists(output.file("RI.h5")));
}

TEST(SoFar, LeavesOutWhatIsOfAnotherRun) {
  const ScratchFolder scratch;
  const OutputFolder output = OutputFolder::open(scratch.path() / "out", "fig12");
  const OutputFolder copy = OutputFolder::open(scratch.path() / "copy", "fig12");
  const RunIdentity before{"fig12", "R", {}, "seed = 7\n"}, now{"fig12", "R", {}, "seed = 8\n"};
  Result result = example_result();
  before.stamp(result);
  write_result(output.file("RD.h5"), result);
  Checkpoint checkpoint = example_checkpoint();
  before.stamp(checkpoint.partial_result);
  output.checkpoints("RI").put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
  now.stamp(result);
  write_result(output.file("RX.h5"), result);
  copy_preliminary_results(output, copy, {{"RD", before}, {"RI", before}});
  EXPECT_EQ(copy_preliminary_results(output, copy, {{"RD", now}, {"RI", now}, {"RX", now}}),
            "RD: left out: of another run: seed = 7 there, 8 now\nRI: left out: of another run: seed = 7 there, 8 "
            "now\nRX: complete\n");
  for (const char* point : {"RD.h5", "RI.h5"}) EXPECT_FALSE(std::filesystem::exists(copy.file(point))) << point;
}

}  // namespace
}  // namespace flowslide
