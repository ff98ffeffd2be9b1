// SPDX-License-Identifier: GPL-2.0-or-later
// A tiny case through the whole program. Collective parts run again on two MPI ranks (program.two_ranks).
#include "program/case_program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

#include "process/mpi_session.hpp"
#include "record/result_file.hpp"
#include "sample/failure.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr const char* case_text = R"(engine = "liggghts"
seed = 1
replicates = 1
size = "2 mm"
count = 3
[scale.quick]
[scale.paper]
count = 30
)";

constexpr const char* claims_text = R"(figure_only = ["b"]
[[claim]]
id = "small"
figure = "Fig. 1"
sentence = "It is small."
metric = "a.size"
relation = "<"
threshold = 0.0025
unit = "m"
origin = "rounding"
[[claim]]
id = "many"
figure = "Fig. 12"
sentence = "There are many."
metric = "b.count"
relation = ">"
threshold = 2
unit = "1"
origin = "rounding"
)";

/// A case of two points that records the calls that it receives.
class Tiny : public Case {
 public:
  CaseDescription description() const override { return {"tiny", "A case.", "1", {"Fig. 1"}, {"liggghts", "other"}}; }
  void read(const Configuration& configuration) override {
    configuration.text("engine", {"liggghts", "other"});
    configuration.integer("seed", Range::not_negative());
    configuration.integer("replicates", Range::between(1, 9));
    size_ = configuration.quantity("size", dimension::length, Range::positive());
    count_ = static_cast<double>(configuration.integer("count", Range::at_least(1)));
  }
  std::vector<Point> points() const override {
    return {{"a", {"1"}, "the \"first\"", 61.2, "loose"}, {"b", {"1", "12"}, "the second", 2.0, "loose"}};
  }
  void print_plan(const Point& point, std::ostream& out) const override {
    std::array<double, 1> last{static_cast<double>(mpi_rank())};
    largest_over_ranks(last);  // engines are made by all ranks together
    out << "plan of " << point.name << " on " << static_cast<int>(last[0]) + 1 << "\n";
  }
  void prepare(const Point& point, int, const ProgressStyle&, const PreparationPoll& poll) const override {
    poll([] { return true; });
    ran.push_back("sample of " + point.name);
  }
  void run(const Point& point, const PointRun& run) const override {
    ran.push_back(point.name);
    provenance = run.provenance_now();
    if (point.name == failing) throw NumericalFailure("grain 7 is lost");
    const Result result = run.result({}, {{"size", size_, "m", "size"}, {"count", count_, "1", "count"}});
    if (mpi_rank() == 0) write_result(run.output.file(point.name + ".h5"), result);
  }
  std::map<std::string, double> metrics(const fs::path& folder, const std::vector<std::string>& points) const override {
    std::map<std::string, double> all;
    for (const std::string& name : points)
      for (const Metric& metric : read_result(folder / (name + ".h5")).metrics)
        all[name + "." + metric.name] = metric.value;
    return all;
  }

  std::string failing;                    ///< point that fails
  mutable std::vector<std::string> ran;
  mutable Provenance provenance;          ///< of the last

 private:
  double size_ = 0.0, count_ = 0.0;
};

struct Outcome {
  int code = -1;
  std::string output, error;
  std::vector<std::string> ran;
  Provenance provenance;
};

class CaseProgramTest : public testing::Test {
 protected:
  CaseProgramTest() {
    fs::create_directory(case_folder());
    scratch_.write("case/case.toml", case_text);
    scratch_.write("case/claims.toml", claims_text);
    fs::current_path(scratch_.path());
  }
  ~CaseProgramTest() override { fs::current_path(before_); }

  fs::path case_folder() const { return scratch_.path() / "case"; }
  fs::path out() const { return scratch_.path() / "out"; }
  /// Nothing but case/ and its two files.
  bool nothing_written() const { return std::distance(fs::recursive_directory_iterator(scratch_.path()), {}) == 3; }
  /// Runs the program with `options`, in `out` unless they say where.
  Outcome run(std::vector<std::string> options, const std::string& failing = "") const {
    if (std::find(options.begin(), options.end(), "--output") == options.end())
      options.insert(options.end(), {"--output", out().string()});
    std::vector<const char*> words{"tiny"};
    for (const std::string& option : options) words.push_back(option.c_str());
    Tiny tiny;
    tiny.failing = failing;
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Outcome outcome;
    outcome.code = run_case(tiny, static_cast<int>(words.size()), words.data(), case_folder());
    outcome.output = testing::internal::GetCapturedStdout();
    outcome.error = testing::internal::GetCapturedStderr();
    outcome.ran = tiny.ran;
    outcome.provenance = tiny.provenance;
    return outcome;
  }
  /// The message about bad input. Expects exit code 2, no output on stdout and no run.
  std::string complaint(const std::vector<std::string>& options) const {
    const Outcome outcome = run(options);
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.output, "");
    EXPECT_TRUE(outcome.ran.empty());
    EXPECT_TRUE(outcome.error.starts_with("flowslide: ")) << outcome.error;
    return outcome.error;
  }

  ScratchFolder scratch_;
  fs::path before_ = fs::current_path();
};

using Names = std::vector<std::string>;

TEST_F(CaseProgramTest, RunsEveryPointAndChecksTheClaims) {
  const Outcome outcome = run({"--seed", "4"});
  EXPECT_EQ(outcome.code, 0) << outcome.error;
  EXPECT_EQ(outcome.ran, (Names{"a", "b"}));
  EXPECT_CONTAINS(outcome.output, "met  ");
  EXPECT_CONTAINS(outcome.output, "cost: 0 s of processor time, 1 min 03 s predicted\n");
  EXPECT_CONTAINS(content_of(out() / "claims.md"), "It is small.");
  EXPECT_CONTAINS(content_of(out() / "claims.json"), "\"id\": \"many\"");
  EXPECT_EQ(outcome.provenance.case_name, "tiny");
  EXPECT_EQ(outcome.provenance.point, "b");
  EXPECT_EQ(outcome.provenance.figure, "1, 12");
  EXPECT_EQ(outcome.provenance.scale, "quick");
  EXPECT_EQ(outcome.provenance.mpi_ranks, 1);
  EXPECT_EQ(outcome.provenance.predicted_seconds, 2.0);
  EXPECT_GE(outcome.provenance.processor_seconds, 0.0);
  EXPECT_LT(outcome.provenance.processor_seconds, 10.0);
  EXPECT_CONTAINS(outcome.provenance.command_line, "tiny --seed 4 --output ");
  const Result result = read_result(out() / "a.h5");
  EXPECT_CONTAINS(result.configuration, "seed = 4\nsize = \"0.002 m\"\n");
  EXPECT_EQ(result.configuration_hash.size(), 32U);
}

TEST_F(CaseProgramTest, RunsAtTheScaleThatIsAskedFor) {
  EXPECT_EQ(run({"--scale", "paper"}).provenance.scale, "paper");
  EXPECT_CONTAINS(read_result(out() / "b.h5").configuration, "count = 30\n");
}

TEST_F(CaseProgramTest, RunsThePointThatIsAskedForAndLeavesTheClaimsToOthers) {
  const Outcome outcome = run({"--point", "b"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.ran, Names{"b"});
  EXPECT_FALSE(fs::exists(out() / "a.h5"));
  EXPECT_FALSE(fs::exists(out() / "claims.md"));
}

TEST_F(CaseProgramTest, SkipsWhatIsComplete) {
  run({});
  const std::string before = content_of(out() / "a.h5");
  const Outcome again = run({});
  EXPECT_EQ(again.code, 0);
  EXPECT_TRUE(again.ran.empty());
  EXPECT_CONTAINS(again.error, "a: the result exists, with this configuration (code ");
  EXPECT_EQ(content_of(out() / "a.h5"), before);
}

TEST_F(CaseProgramTest, RunsWhatIsMissing) {
  run({"--point", "a"});
  EXPECT_EQ(run({}).ran, Names{"b"});
}

TEST_F(CaseProgramTest, RefusesAPointOfAnotherConfiguration) {
  run({"--point", "a"});
  const std::string before = content_of(out() / "a.h5");
  const std::string message = complaint({"--set", "count=4"});
  EXPECT_CONTAINS(message,
                  (out() / "a.h5").string() + " is the result of another run (count = 3 there, 4 now), and is ");
  EXPECT_CONTAINS(message,
                  "not overwritten; choose another folder with --output, give the options that it was made with, or");
  EXPECT_EQ(content_of(out() / "a.h5"), before);
}

TEST_F(CaseProgramTest, RefusesADamagedResultBeforeARunIsSpentOnIt) {
  run({"--point", "a"});
  std::string bytes = content_of(out() / "a.h5");
  bytes[bytes.size() / 2] ^= 1;
  std::ofstream(out() / "a.h5", std::ios::binary) << bytes;
  const std::string message = complaint({"--point", "a"});
  EXPECT_CONTAINS(message, (out() / "a.h5").string());
  EXPECT_CONTAINS(message, "delete it and execute that run again");
  fs::remove(out() / "a.h5");
  EXPECT_EQ(run({"--point", "a"}).ran, Names{"a"});
}

TEST_F(CaseProgramTest, EndsWithThreeAfterANumericalFailure) {
  const Outcome failed = run({}, "b");
  EXPECT_EQ(failed.code, 3);
  EXPECT_EQ(failed.error, "flowslide: grain 7 is lost\n");
  EXPECT_FALSE(fs::exists(out() / "b.h5"));
  EXPECT_EQ(run({}).ran, Names{"b"});  // keeps the complete point, and runs the failed one again
}

TEST_F(CaseProgramTest, EndsWithFourWhenAClaimIsNotMet) {
  std::string text = case_text;
  text.replace(text.find("2 mm"), 4, "3 mm");
  scratch_.write("case/case.toml", text);
  const Outcome outcome = run({});
  EXPECT_EQ(outcome.code, 4);
  EXPECT_EQ(outcome.ran, (Names{"a", "b"}));
  EXPECT_CONTAINS(outcome.output, "NOT MET");
  EXPECT_CONTAINS(outcome.output, "0.003 is not < 0.0025 m (It is small.)");
  EXPECT_CONTAINS(content_of(out() / "claims.md"), "**not met**");
}

TEST_F(CaseProgramTest, ChecksWithoutARun) {
  run({});
  const Outcome outcome = run({"--check", "--json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.ran.empty());
  EXPECT_EQ(outcome.output, content_of(out() / "claims.json"));
  EXPECT_CONTAINS(content_of(out() / "runs.dat"), "\na a quick 0\nb b quick 0\n");
  EXPECT_CONTAINS(content_of(out() / "metrics.dat"), "\na count 3\na size 0.002\nb count 3\nb size 0.002\n");
  EXPECT_CONTAINS(complaint({"--check", "--output", "none"}), "is not there: run the case first");
  EXPECT_FALSE(fs::exists("none"));
}

TEST_F(CaseProgramTest, JudgesNoResultsOfAnotherConfiguration) {
  run({});
  const std::string message = complaint({"--check", "--set", "count=4"});
  EXPECT_CONTAINS(message,
                  (out() / "a.h5").string() + " is the result of another run (count = 3 there, 4 now); choose another");
  // One that was not asked for is left out, with a word.
  run({"--point", "a", "--set", "count=4", "--afresh"});
  const Outcome of_a = run({"--check", "--point", "a", "--set", "count=4"});
  EXPECT_EQ(of_a.code, 0);
  EXPECT_CONTAINS(of_a.error,
                  (out() / "b.h5").string() + " is the result of another run (count = 3 there, 4 now); it is left out");
}

TEST_F(CaseProgramTest, JudgesNoResultOfAnotherPoint) {
  run({});
  fs::copy_file(out() / "a.h5", out() / "b.h5", fs::copy_options::overwrite_existing);
  EXPECT_CONTAINS(complaint({"--check"}), "another run (point name = a there, b now)");
}

TEST_F(CaseProgramTest, ReplacesResultsOfAnotherRunOnlyWhenAsked) {
  run({});
  EXPECT_EQ(run({"--afresh"}).ran, Names{});  // both results belong to this run
  EXPECT_EQ(run({"--afresh", "--set", "count=4"}).ran, (Names{"a", "b"}));
  EXPECT_CONTAINS(read_result(out() / "a.h5").configuration, "count = 4\n");
  EXPECT_CONTAINS(run({"--status"}).output, "outdated");
}

TEST_F(CaseProgramTest, ChecksTheClaimsOfTheFiguresOfAPoint) {
  run({"--point", "a"});  // draws figure 1, whose claim is met; "Fig. 12" is not its figure though it begins alike
  const Outcome of_a = run({"--check", "--point", "a"});
  EXPECT_CONTAINS(of_a.output, "small");
  EXPECT_CONTAINS_NOT(of_a.output, "many");
  const Outcome of_b = run({"--check", "--point", "b"});  // draws both, and was not run
  EXPECT_CONTAINS(of_b.output, "not evaluated  Fig. 12  many");
  EXPECT_CONTAINS(of_b.output, "the metric \"b.count\" was not measured");
  std::string text = claims_text;  // a claim about no figure is checked if all points are named
  scratch_.write("case/claims.toml", text.replace(text.find("Fig. 12"), 7, "sec. 2.3"));
  EXPECT_CONTAINS(run({"--check", "--point", "a", "--point", "b"}).output, "sec. 2.3");
}

TEST_F(CaseProgramTest, AnswersInJsonThoughThereIsNoClaim) {
  run({});
  run({"--check"});
  scratch_.write("case/claims.toml", "");
  EXPECT_EQ(run({"--check", "--json"}).output, "[]\n");
  EXPECT_FALSE(std::filesystem::exists(out() / "claims.md"));  // its claims are gone
}

TEST_F(CaseProgramTest, ListsAndWritesNothing) {
  const Outcome outcome = run({"--list"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.output, "# name\tseconds\tdescription\na\t61\tthe \"first\"\nb\t2\tthe second\n");
  EXPECT_EQ(run({"--list", "--point", "b"}).output, "# name\tseconds\tdescription\nb\t2\tthe second\n");
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, ListsInJsonAndWritesNothing) {
  const Outcome outcome = run({"--list", "--json"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(nlohmann::json::parse(outcome.output), nlohmann::json::parse(R"({"points": [
      {"name": "a", "figures": ["1"], "predicted_seconds": 61.2, "sample": "loose", "figure_only": false,
       "description": "the \"first\""},
      {"name": "b", "figures": ["1", "12"], "predicted_seconds": 2.0, "sample": "loose", "figure_only": true,
       "description": "the second"}], "claims": ["small", "many"]})"));
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, PreparesEachSampleOnceAndWritesNoResult) {
  const Outcome outcome = run({"--prepare"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.ran, std::vector<std::string>{"sample of a"});
  EXPECT_EQ(run({"--prepare", "--point", "b"}).ran, std::vector<std::string>{"sample of b"});
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, PlansAndWritesNothing) {
  const Outcome outcome = run({"--dry-run", "--point", "a", "--set", "size=1 cm"});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_TRUE(outcome.output.starts_with("# resolved configuration, hash ")) << outcome.output;
  EXPECT_CONTAINS(outcome.output, "a key with a bare number takes bare numbers only\n");
  EXPECT_CONTAINS(outcome.output, fmt::format("{:<60} # case/case.toml:5\n", "count = 3"));
  EXPECT_CONTAINS(outcome.output, fmt::format("{:<60} # --set size=1 cm\n", "size = \"0.01 m\""));
  EXPECT_CONTAINS(outcome.output, "\n# changed: size = \"1 cm\", not \"2 mm\"\n");
  EXPECT_CONTAINS(outcome.output, "# run a: the \"first\"; predicted 1 min 01 s on one core\nplan of a on 1\n");
  EXPECT_CONTAINS_NOT(outcome.output, "run b");
  EXPECT_TRUE(outcome.ran.empty());
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, RefusesBadValuesWithPlaceAndRange) {
  EXPECT_EQ(complaint({"--set", "size=-1 mm"}),
            "flowslide: --set size=-1 mm: the value is not allowed: it must be above 0 m; give another\n");
  EXPECT_CONTAINS(complaint({"--set", "size=3 s"}), "--set size=3 s: size: ");
  scratch_.write("user.toml", "\ncount = 0\n");
  EXPECT_CONTAINS(complaint({"--config", "user.toml"}),
                  "user.toml:2:9: count = 0 is not allowed: it must be at least 1; change it there or");
  EXPECT_CONTAINS(complaint({"--engine", "othr"}), "did you mean \"other\"?");
  EXPECT_CONTAINS(complaint({"--set", "engine=othr"}),
                  "--set engine=othr: the value is not allowed: it must be \"liggghts\" or \"other\"; did you mean");
  fs::remove(scratch_.path() / "user.toml");
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, RefusesUnknownKeysAndPointsWithTheNearest) {
  EXPECT_EQ(complaint({"--set", "cuont=4"}),
            "flowslide: --set cuont=4: unknown key \"cuont\"; did you mean \"count\"?\n");
  EXPECT_EQ(complaint({"--point", "c"}),
            "flowslide: --point: \"c\" does not exist; it must be \"a\" or \"b\"; did you mean \"a\"?\n");
  EXPECT_TRUE(nothing_written());
}

TEST_F(CaseProgramTest, RefusesFoldersThatAreNotItsOwn) {
  fs::create_directory(out());
  scratch_.write("out/thesis.tex", "years of work");
  EXPECT_CONTAINS(complaint({}), "holds files that this program did not write, such as thesis.tex; choose another");
  EXPECT_EQ(std::distance(fs::directory_iterator(out()), {}), 1);
  const fs::path below = out() / "thesis.tex" / "below";
  EXPECT_CONTAINS(complaint({"--output", below.string()}), "the output folder " + below.string() + " cannot be");
  EXPECT_CONTAINS(complaint({"--output", (out() / "thesis.tex").string()}), "is a file, not a folder");
  EXPECT_EQ(content_of(out() / "thesis.tex"), "years of work");
}

TEST_F(CaseProgramTest, SaysWhichFileOfTheCaseIsMissing) {
  fs::remove(case_folder() / "case.toml");
  EXPECT_CONTAINS(complaint({}), (case_folder() / "case.toml").string());
  EXPECT_FALSE(fs::exists(out()));
}

TEST(CaseProgramRanks, PlanTogetherAndLetTheFirstSpeak) {
  const ScratchFolder scratch;
  scratch.write("case.toml", case_text);
  const char* words[] = {"tiny", "--dry-run"};
  Tiny tiny;
  testing::internal::CaptureStdout();
  EXPECT_EQ(run_case(tiny, 2, words, scratch.path()), 0);
  const std::string output = testing::internal::GetCapturedStdout();
  if (mpi_rank() == 0)
    EXPECT_CONTAINS(output, "plan of b on " + std::to_string(mpi_ranks()) + "\n");
  else
    EXPECT_EQ(output, "");
}

}  // namespace
}  // namespace flowslide
