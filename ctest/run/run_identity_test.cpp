// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/run_identity.hpp"

#include "experiment/loading_record.hpp"
#include "record/damage.hpp"
#include "record/hash.hpp"
#include "support/messages.hpp"
#include "support/stress_table.hpp"

namespace flowslide {
namespace {

RunInputs inputs(const std::string& engine, const StressTable& loading = {{0.0, 1.0}, {0.0, 500.0}}) {
  return {engine, engine == "elastic" ? "" : "native", {input_table("quake.txt", loading)}};
}

const std::string configuration = "engine = \"native\"\nslope.angle = \"0.1 rad\"\n";

RunVersions versions(const RunInputs& inputs) {
  RunVersions versions{"0.1.0 (slide)", "0.1.0 (law of " + inputs.engine + ")"};
  if (!inputs.preparation_engine.empty()) {
    versions.preparation = inputs.preparation_engine + " 0.1.0 (law), procedure 3";
    versions.search = "0.1.0 (steps)";
  }
  return versions;
}

RunIdentity identity(const RunInputs& inputs, const std::string& of = configuration) {
  return {"fig12_pulse", "RD", inputs, of, versions(inputs)};
}

Result made_by(const RunIdentity& identity) {
  Result result;
  identity.stamp(result);
  return result;
}

/// The same result with another version in one line of its identity.
Result with_line(Result result, const std::string& name, const std::string& value) {
  const std::size_t start = result.identity.find(name + " = "), end = result.identity.find('\n', start);
  EXPECT_NE(start, std::string::npos) << result.identity;
  result.identity.replace(start, end - start, name + " = " + value);
  return result;
}

TEST(RunIdentity, IsRecognizedInTheResult) {
  const RunIdentity now = identity(inputs("native"));
  const Result result = made_by(now);
  EXPECT_EQ(RunIdentity(result), now);
  EXPECT_EQ(now.difference_from(RunIdentity(result)), "");
  EXPECT_EQ(RunIdentity::from_text(now.text()), now);
  EXPECT_EQ(result.configuration, configuration);
  EXPECT_EQ(result.configuration_hash, hash_of(configuration));
  EXPECT_EQ(stress_table(result.inputs.at(0)).change, (std::vector{0.0, 500.0}));
}

TEST(RunIdentity, DiffersByEverythingThatWentIn) {
  const RunIdentity now = identity(inputs("native"));
  const auto difference = [&](const RunIdentity& there) { return now.difference_from(there); };
  EXPECT_EQ(difference(identity(inputs("native"), "engine = \"native\"\nslope.angle = \"0.2 rad\"\n")),
            "slope.angle = \"0.2 rad\" there, \"0.1 rad\" now");
  EXPECT_EQ(difference({"fig12_pulse", "RI", inputs("native"), configuration, versions(inputs("native"))}),
            "point name = RI there, RD now");
  EXPECT_EQ(difference({"fig13_k", "RD", inputs("native"), configuration, versions(inputs("native"))}),
            "case name = fig13_k there, fig12_pulse now");
  EXPECT_CONTAINS(difference(identity(inputs("native", {{0.0, 1.0}, {0.0, 501.0}}))), "loading table = 2 rows (hash ");
  EXPECT_CONTAINS(difference(identity(inputs("native-mixed"))), "engine version = native-mixed ");
  RunInputs by_another = inputs("native");
  by_another.preparation_engine = "native-mixed";
  EXPECT_CONTAINS(difference(identity(by_another)), "preparation version = native-mixed ");
}

TEST(RunIdentity, DiffersByTheSourcesOfEnginePreparationAndSearch) {
  const RunIdentity now = identity(inputs("native"));
  const Result result = made_by(now);
  for (const char* name : {"run version", "engine version", "preparation version", "sample search version"})
    EXPECT_CONTAINS(now.difference_from(RunIdentity(with_line(result, name, "native 0.1.0 (of another law)"))),
                    std::string(name) + " = native 0.1.0 (of another law) there, ");
  EXPECT_CONTAINS(now.text(), "engine version = native 0.1.0 (law of native)\n");
  EXPECT_CONTAINS(now.text(), "preparation version = native 0.1.0 (law), procedure 3\n");
  EXPECT_CONTAINS(now.text(), "sample search version = 0.1.0 (steps)\n");
}

TEST(RunIdentity, RefusesAnEngineWithoutItsVersion) {
  EXPECT_THROW(RunIdentity("fig12_pulse", "RD", inputs("native"), configuration), std::invalid_argument);
  EXPECT_THROW(RunIdentity("fig12_pulse", "RD", inputs("native"), configuration, {"0.1.0"}), std::invalid_argument);
}

TEST(RunIdentity, OfAClosedFormSampleIsItsNameAndVersion) {
  const RunIdentity elastic = identity(inputs("elastic"));
  EXPECT_CONTAINS(elastic.text(), "engine version = elastic 0.1.0 (law of elastic)\n");
  EXPECT_CONTAINS_NOT(elastic.text(), "preparation version");
  EXPECT_CONTAINS(elastic.difference_from(identity(inputs("critical_state"))), "engine version = critical_state ");
}

TEST(RunIdentity, OfAnOlderVersionIsNeverTheSame) {
  Result old = made_by(identity(inputs("elastic")));
  old.identity.clear();
  EXPECT_CONTAINS(identity(inputs("elastic")).difference_from(RunIdentity(old)), "of a version that recorded neither");
}

TEST(FindResult, TellsWhatAFileIsToARun) {
  const ScratchFolder scratch;
  const auto file = scratch.path() / "RD.h5";
  const RunIdentity now = identity(inputs("elastic"));
  EXPECT_EQ(find_result(file, now).standing, Standing::absent);
  write_result(file, made_by(now));
  EXPECT_EQ(find_result(file, now).standing, Standing::complete);
  EXPECT_EQ(find_result(file, now).problem, "");
  const FoundResult other = find_result(file, identity(inputs("elastic"), "engine = \"elastic\"\n"));
  EXPECT_EQ(other.standing, Standing::other);
  EXPECT_CONTAINS(other.problem, "slope.angle = \"0.1 rad\" is only there");
  overwrite(file, "torn");
  EXPECT_EQ(find_result(file, now).standing, Standing::damaged);
  EXPECT_CONTAINS(find_result(file, now).problem, file.string());
}

}  // namespace
}  // namespace flowslide
