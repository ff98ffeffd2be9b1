// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/command_line.hpp"

#include <cmath>
#include <limits>

#include "configuration/error.hpp"
#include "process/exit_code.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

const CaseDescription description{
    "fig03_undrained", "Undrained simple shear.", "0.1.0 (abc)", {"Fig. 3", "Fig. 4"}, {"liggghts", "native"}};

CommandLine read(const std::vector<const char*>& options) {
  std::vector<const char*> words{"fig03_undrained"};
  words.insert(words.end(), options.begin(), options.end());
  return parse(static_cast<int>(words.size()), words.data(), description);
}

std::string complaint(const std::vector<const char*>& options) {
  return message_of<ConfigurationError>([&] { read(options); });
}

TEST(CommandLine, HasDefaults) {
  const CommandLine c = read({});
  EXPECT_EQ(c.scale, "quick");
  EXPECT_EQ(c.output, "results/fig03_undrained/quick");
  EXPECT_FALSE(c.configuration_file);
  EXPECT_FALSE(c.dry_run || c.list || c.check || c.json);
  EXPECT_TRUE(c.points.empty() && c.overrides.empty());
}

TEST(CommandLine, ReadsEveryOption) {
  const CommandLine c = read({"--config", "a.toml",   "--set",   "s.a=3 kPa", "--set",   "s.b=x=y",      "--scale",
                              "paper",    "--engine", "native",  "--seed",    "7",       "--replicates", "3",
                              "--output", "/tmp/o",   "--point", "loose",     "--point", "dense",        "--dry-run"});
  EXPECT_EQ(c.configuration_file, "a.toml");
  EXPECT_EQ(c.scale, "paper");
  EXPECT_EQ(c.output, "/tmp/o");
  EXPECT_EQ(c.points, (std::vector<std::string>{"loose", "dense"}));
  EXPECT_TRUE(c.dry_run);
  ASSERT_EQ(c.overrides.size(), 5U);
  EXPECT_EQ(c.overrides[0].key, "s.a");
  EXPECT_EQ(c.overrides[0].value, "3 kPa");
  EXPECT_EQ(c.overrides[0].option, "--set s.a=3 kPa");
  EXPECT_EQ(c.overrides[1].key, "s.b");
  EXPECT_EQ(c.overrides[1].value, "x=y");
  EXPECT_EQ(c.overrides[2].key + c.overrides[2].value, "engine\"native\"");
  EXPECT_EQ(c.overrides[3].key + c.overrides[3].value, "seed7");
  EXPECT_EQ(c.overrides[4].key + c.overrides[4].value, "replicates3");
  EXPECT_TRUE(read({"--list", "--json"}).json);
  EXPECT_TRUE(read({"--check"}).check);
  EXPECT_EQ(read({"--scale", "paper"}).output, "results/fig03_undrained/paper");
}

TEST(CommandLine, LaysOptionsOverTheConfiguration) {
  const ScratchFolder scratch;
  const auto file =
      scratch.write("case.toml", "engine = 'liggghts'\nseed = 1\nreplicates = 1\n[s]\na = 1\n[scale.quick]\n");
  const Configuration c(layers_of(read({"--engine", "native", "--seed", "7", "--set", "s.a=5 %"}), file));
  EXPECT_EQ(c.text("engine"), "native");
  EXPECT_EQ(c.integer("seed"), 7);
  EXPECT_EQ(c.integer("replicates"), 1);
  EXPECT_EQ(c.number("s.a"), 0.05);
}

TEST(CommandLine, NamesTheOptionInAComplaintAboutItsValue) {
  const ScratchFolder scratch;
  const auto file = scratch.write("case.toml", "replicates = 1\n[scale.quick]\n");
  const Configuration c(layers_of(read({"--replicates", "30"}), file));
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { c.integer("replicates", Range::at_most(9)); }),
                  "--replicates 30: the value is not allowed: it must be at most 9");
}

TEST(CommandLine, RefusesBadValues) {
  EXPECT_CONTAINS(complaint({"--engine", "ligghts"}), "must be \"liggghts\" or \"native\"; did you mean \"liggghts\"?");
  EXPECT_CONTAINS(complaint({"--scale", "papers"}), "must be \"quick\" or \"paper\"; did you mean \"paper\"?");
  EXPECT_CONTAINS(complaint({"--set", "novalue"}), "\"novalue\" is not KEY=VALUE");
  EXPECT_CONTAINS(complaint({"--set", "=3"}), "\"=3\" is not KEY=VALUE");
  EXPECT_CONTAINS(complaint({"--seed", "-1"}), "--seed");
  EXPECT_CONTAINS(complaint({"--seed", "x"}), "--seed: \"x\" is not allowed; it must be an integer from 0 to ");
  EXPECT_CONTAINS(complaint({"--seed", "99999999999999999999"}), "--seed");
  EXPECT_EQ(read({"--seed", "1000000000"}).overrides.front().value, "1000000000");
  EXPECT_CONTAINS(complaint({"--replicates", "0"}), "--replicates");
  EXPECT_CONTAINS(complaint({"--replicates", "1.5"}), "--replicates");
  EXPECT_CONTAINS(complaint({"--output", ""}), "--output");
  EXPECT_CONTAINS(complaint({"--config"}), "--config");
  EXPECT_CONTAINS(complaint({"--seed", "1", "--seed", "2"}), "--seed");
}

TEST(CommandLine, RefusesUnknownOptionsWithTheNearest) {
  EXPECT_CONTAINS(complaint({"--dryrun"}), "--dryrun");
  EXPECT_CONTAINS(complaint({"--dryrun"}), "did you mean \"--dry-run\"?");
  EXPECT_CONTAINS(complaint({"--sede=3"}), "did you mean \"--seed\"?");
  EXPECT_CONTAINS(complaint({"stray"}), "stray");
  EXPECT_CONTAINS(complaint({"--set", "a=1", "stray"}), "stray");
  EXPECT_CONTAINS(complaint({"stray"}), "see fig03_undrained --help");
}

TEST(CommandLine, RefusesOptionsThatExcludeEachOther) {
  EXPECT_CONTAINS(complaint({"--dry-run", "--list"}), "--list");
  EXPECT_CONTAINS(complaint({"--dry-run", "--check"}), "--check");
  EXPECT_CONTAINS(complaint({"--list", "--check"}), "--check");
  EXPECT_CONTAINS(complaint({"--prepare", "--check"}), "--prepare");
  EXPECT_CONTAINS(complaint({"--json"}), "--json needs --list, --status or --check");
}

TEST(CommandLine, HelpNamesEveryOptionWithExamplesAndExitCodes) {
  const std::string help = message_of<FinishedEarly>([] { read({"--help"}); });
  for (const char* part : {"Undrained simple shear.",
                           "Fig. 3, Fig. 4",
                           "--config",
                           "--set",
                           "--scale",
                           "--engine",
                           "liggghts, native",
                           "--seed",
                           "--replicates",
                           "--output",
                           "--point",
                           "--dry-run",
                           "--list",
                           "--check",
                           "--prepare",
                           "--json",
                           "--version",
                           "--help",
                           "What to run",
                           "Instead of a run",
                           "Long runs",
                           "--resume",
                           "--afresh",
                           "--max-walltime",
                           "--status",
                           "Examples:",
                           "Exit codes:",
                           "2 configuration",
                           "75 stopped but resumable",
                           "130 interrupted"}) {
    EXPECT_CONTAINS(help, part);
  }
}

TEST(CommandLine, HelpNamesNoFigureWhereThereIsNone) {
  const CaseDescription hard{"hard", "Hard scenes.", "1", {}, {"native"}};
  const char* words[] = {"hard", "--help"};
  const std::string help = message_of<FinishedEarly>([&] { parse(2, words, hard); });
  EXPECT_CONTAINS(help, "Hard scenes.");
  EXPECT_CONTAINS_NOT(help, "Figures");
}

TEST(CommandLine, VersionNamesCaseAndVersion) {
  EXPECT_EQ(message_of<FinishedEarly>([] { read({"--version"}); }), "fig03_undrained 0.1.0 (abc)\n");
}

TEST(SelectedPoints, KeepTheOrderOfTheCase) {
  const std::vector<std::string> all{"a", "bb", "c"};
  EXPECT_EQ(selected_points(read({}), all), all);
  EXPECT_EQ(selected_points(read({"--point", "c", "--point", "a"}), all), (std::vector<std::string>{"a", "c"}));
}

TEST(SelectedPoints, RefuseAnUnknownName) {
  EXPECT_CONTAINS(message_of<ConfigurationError>([] {
                    selected_points(read({"--point", "loos"}), {"loose", "dense"});
                  }),
                  "--point: \"loos\" does not exist; it must be \"loose\" or \"dense\"; did you mean \"loose\"?");
}

TEST(CommandLine, ReadsHowLongARunMayTake) {
  EXPECT_EQ(read({}).checkpoint_interval, 180.0);
  EXPECT_TRUE(std::isinf(read({}).max_walltime));
  EXPECT_EQ(read({"--checkpoint-interval", "30 s"}).checkpoint_interval, 30.0);
  EXPECT_EQ(read({}).threads, 0);
  EXPECT_EQ(read({"--threads", "2"}).threads, 2);
  EXPECT_EQ(read({"--max-walltime", "1.5 h"}).max_walltime, 5400.0);
  EXPECT_EQ(complaint({"--max-walltime", "24"}),
            "--max-walltime: \"24\" has no unit: it would be 24 s; write \"24 h\" or \"24 s\"");
  EXPECT_EQ(complaint({"--checkpoint-interval", "3"}),
            "--checkpoint-interval: \"3\" has no unit: it would be 3 s; write \"3 min\" or \"3 s\"");
  EXPECT_CONTAINS(complaint({"--max-walltime", "2 kPa"}), "--max-walltime: ");
  EXPECT_CONTAINS(complaint({"--max-walltime", "0"}), "is not above 0; write, for example, --max-walltime \"90 min\"");
  EXPECT_CONTAINS(complaint({"--checkpoint-interval", "inf"}), "--checkpoint-interval: ");
  EXPECT_CONTAINS(complaint({"--threads", "0"}), "\"0\" is not allowed; it must be an integer from 1 to 1024");
}

TEST(CommandLine, ReadsWhetherToGoOn) {
  EXPECT_FALSE(read({}).resume || read({}).afresh);
  EXPECT_TRUE(read({"--resume"}).resume);
  EXPECT_TRUE(read({"--afresh"}).afresh);
  EXPECT_CONTAINS(complaint({"--resume", "--afresh"}), "excludes");
  EXPECT_CONTAINS(complaint({"--status", "--list"}), "exclude each other");
  EXPECT_TRUE(read({"--status", "--json"}).json);
}

}  // namespace
}  // namespace flowslide
