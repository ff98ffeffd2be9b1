// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/case.hpp"

#include <gtest/gtest.h>

#include "record/damage.hpp"
#include "run/example_checkpoint.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class PointRunTest : public testing::Test {
 protected:
  PointRun run() { return {output_, provenance_, identity_, {}, 1, checkpoints_}; }

  ScratchFolder scratch_;
  OutputFolder output_ = OutputFolder::open(scratch_.path() / "results", "tiny");
  RunIdentity identity_{"tiny", "a", {}, "seed = 7\n"};
  Provenance provenance_ = [] {
    Provenance provenance;
    provenance.point = "a";
    provenance.mpi_ranks = 2;
    return provenance;
  }();
  RunControl control_{RunLimits{}};
  PointCheckpoints checkpoints_{output_.checkpoints("a"), control_, identity_};
};

TEST_F(PointRunTest, CountsItsOwnTimeOnEachOfItsRanks) {
  PointRun half_a_second = run();
  half_a_second.begun -= CLOCKS_PER_SEC / 2;
  const double seconds = half_a_second.provenance_now().processor_seconds;
  EXPECT_GE(seconds, 2 * 0.5);
  EXPECT_LT(seconds, 2 * 0.5 + 10.0);
}

TEST_F(PointRunTest, CountsWhatItsCheckpointHasCost) {
  Checkpoint checkpoint = example_checkpoint();
  identity_.stamp(checkpoint.partial_result);
  checkpoint.partial_result.provenance.processor_seconds = 1000.0;
  output_.checkpoints("a").put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
  testing::internal::CaptureStderr();
  PointCheckpoints found(output_.checkpoints("a"), control_, identity_);
  testing::internal::GetCapturedStderr();
  const PointRun goes_on{output_, provenance_, identity_, {}, 1, found};
  EXPECT_GE(goes_on.provenance_now().processor_seconds, 1000.0);
  EXPECT_LT(goes_on.provenance_now().processor_seconds, 1010.0);
}

TEST_F(PointRunTest, StampsItsResultWithItsIdentity) {
  const Result result = run().result({}, {{"size", 2e-3, "m", "size"}});
  EXPECT_EQ(RunIdentity(result), identity_);
  EXPECT_EQ(result.provenance.point, "a");
  EXPECT_EQ(result.metrics.at(0).name, "size");
}

}  // namespace
}  // namespace flowslide
