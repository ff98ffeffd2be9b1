// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/begin_point.hpp"

#include "process/exit_code.hpp"
#include "record/damage.hpp"
#include "run/example_checkpoint.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class BeginPoint : public testing::Test {
 protected:
  static RunIdentity identity(const std::string& configuration = "mu = 1\n") {
    return {"fig03", "loose", {}, configuration};
  }
  bool complete(const RunIdentity& identity, bool afresh = false) const {
    return begin_point(output_, "loose", identity, afresh).complete;
  }
  std::string complaint(const RunIdentity& identity) const {
    return message_of<Refused>([&] { complete(identity); });
  }
  void write(const RunIdentity& identity) const {
    Result result = example_result();
    identity.stamp(result);
    write_result(output_.file("loose.h5"), result, IfExists::replace);
    overwrite(output_.file("loose.dat"), "table");
    overwrite(output_.file("loose_profiles.dat"), "profiles");
  }
  void keep(const RunIdentity& identity) const {
    Checkpoint checkpoint = example_checkpoint();
    identity.stamp(checkpoint.partial_result);
    output_.checkpoints("loose").put([&](hdf5::Group& root) { write_checkpoint(root, checkpoint); });
  }
  bool there(const char* file) const { return std::filesystem::exists(output_.file(file)); }

  ScratchFolder scratch_;
  OutputFolder output_ = OutputFolder::open(scratch_.path(), "fig03");
};

TEST_F(BeginPoint, NotesItsIdentityAndGoesOnAsItWas) {
  EXPECT_FALSE(complete(identity()));
  EXPECT_EQ(output_.noted("loose"), identity().text());
  keep(identity());
  EXPECT_FALSE(complete(identity()));
  EXPECT_FALSE(output_.checkpoints("loose").empty());
}

TEST_F(BeginPoint, LetsOneProcessRunAPoint) {
  const BegunPoint held = begin_point(output_, "loose", identity(), false);
  EXPECT_CONTAINS(complaint(identity()), "is in use: another process executes the run \"loose\" there");
  EXPECT_NO_THROW(begin_point(output_, "dense", identity(), false));
}

TEST_F(BeginPoint, KeepsACompleteResultOfThisRunWhateverIsAsked) {
  write(identity());
  keep(identity());
  for (const bool afresh : {false, true}) EXPECT_TRUE(complete(identity(), afresh));
  EXPECT_TRUE(there("loose.h5"));
  EXPECT_TRUE(output_.checkpoints("loose").empty());
}

TEST_F(BeginPoint, ReplacesAResultOfAnotherRunOnlyWhenAsked) {
  write(identity());
  const std::string message = complaint(identity("mu = 2\n"));
  EXPECT_CONTAINS(message, output_.file("loose.h5").string() + " is the result of another run (mu = 1 there, 2 now)");
  EXPECT_CONTAINS(message, "--afresh");
  EXPECT_TRUE(there("loose.h5"));
  EXPECT_FALSE(complete(identity("mu = 2\n"), true));
  EXPECT_EQ(output_.noted("loose"), identity("mu = 2\n").text());
  for (const char* file : {"loose.h5", "loose.dat", "loose_profiles.dat"}) EXPECT_FALSE(there(file)) << file;
}

TEST_F(BeginPoint, ReplacesADamagedResultOnlyWhenAsked) {
  overwrite(output_.file("loose.h5"), "torn");
  EXPECT_CONTAINS(message_of<CorruptFileError>([&] { complete(identity()); }),
                  "delete it and execute that run again, or begin it anew with --afresh");
  EXPECT_TRUE(there("loose.h5"));
  EXPECT_FALSE(complete(identity(), true));
  EXPECT_FALSE(there("loose.h5"));
}

TEST_F(BeginPoint, RemovesCheckpointsOfAnotherRunOnlyWhenAsked) {
  EXPECT_FALSE(complete(identity()));
  keep(identity());
  EXPECT_CONTAINS(complaint(identity("mu = 2\n")), "of another run (mu = 1 there, 2 now)");
  EXPECT_EQ(output_.noted("loose"), identity().text());
  EXPECT_FALSE(complete(identity("mu = 2\n"), true));
  EXPECT_TRUE(output_.checkpoints("loose").empty());
}

TEST_F(BeginPoint, LeavesNoTableOfAnotherRunThatWasBegunAlone) {
  EXPECT_FALSE(complete(identity()));
  overwrite(output_.file("loose_profiles.dat"), "killed between its tables and its result");
  overwrite(output_.file("loose_r2.dat"), "of another point");
  EXPECT_FALSE(complete(identity("mu = 2\n")));
  EXPECT_FALSE(there("loose_profiles.dat"));
  EXPECT_TRUE(there("loose_r2.dat"));
}

}  // namespace
}  // namespace flowslide
