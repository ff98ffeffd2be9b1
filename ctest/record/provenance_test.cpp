// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/provenance.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "temporary_folder.hpp"

namespace flowslide {
namespace {

const std::filesystem::path source = FLOWSLIDE_SOURCE_DIR;

/// What a command prints, without its last line break.
std::string output_of(const std::string& command) {
  FILE* pipe = ::popen(command.c_str(), "r");
  std::string text;
  std::array<char, 4096> buffer{};
  while (const auto count = std::fread(buffer.data(), 1, buffer.size(), pipe)) text.append(buffer.data(), count);
  ::pclose(pipe);
  while (text.ends_with('\n')) text.pop_back();
  return text;
}

TEST(Provenance, KnowsTheBuild) {
  const auto provenance = start_provenance({});
  EXPECT_TRUE(std::regex_match(provenance.code_version, std::regex("[0-9]+\\.[0-9]+\\.[0-9]+")))
      << provenance.code_version;
  EXPECT_TRUE(std::regex_match(provenance.compiler, std::regex("[A-Za-z]+ [0-9.]+"))) << provenance.compiler;
  EXPECT_NE(provenance.compiler_flags.find("-ffp-contract=off"), std::string::npos) << provenance.compiler_flags;
}

TEST(Provenance, KnowsTheRevisionInARepositoryAndOnlyThere) {
  const auto provenance = start_provenance({});
  if (std::filesystem::exists(source / ".git")) {
    EXPECT_TRUE(std::regex_match(provenance.git_revision, std::regex("[0-9a-f]{40}"))) << provenance.git_revision;
    EXPECT_TRUE(provenance.git_state == "clean" || provenance.git_state == "dirty") << provenance.git_state;
  } else {
    EXPECT_EQ(provenance.git_revision, "unknown");
    EXPECT_EQ(provenance.git_state, "unknown: the source is no git checkout");
  }
}

TEST(Provenance, QuotesThePapersDoiAsCited) {
  std::ifstream citation(source / "CITATION.cff");
  const std::string text((std::istreambuf_iterator<char>(citation)), {});
  // LIGGGHTS's own article is cited as well; its DOI must never pass for the paper's.
  const auto paper = text.substr(0, text.find("scope: LIGGGHTS"));
  const auto doi = start_provenance({}).paper_doi;
  if (paper.find("\n    doi:") == std::string::npos) EXPECT_EQ(doi, "unknown");
  else EXPECT_NE(paper.find("doi: " + doi), std::string::npos) << doi;
}

TEST(Provenance, KnowsHostAndTime) {
  const auto before = output_of("date -u +%Y-%m-%dT%H:%M:%SZ");
  const auto provenance = start_provenance({});
  const auto after = output_of("date -u +%Y-%m-%dT%H:%M:%SZ");
  EXPECT_EQ(provenance.host, output_of("uname -n"));
  EXPECT_LE(before, provenance.start_time);
  EXPECT_LE(provenance.start_time, after);
}

TEST(ShellLine, IsWhatTheShellReadsBack) {
  const std::array words{"printf", "%s\\n", "plain", "two words", "it's", "", "$HOME", "a\"b", "x;y", "5°"};
  const auto line = shell_line(words);
  EXPECT_EQ(line.find("'plain'"), std::string::npos) << line;
  EXPECT_EQ(output_of(line), "plain\ntwo words\nit's\n\n$HOME\na\"b\nx;y\n5°");
}

/// The script that makes build_values.hpp, run on a source tree of our own.
class BuildInformation : public ::testing::Test {
 protected:
  std::string run() const {
    const auto script = (source / "core/record/build_information.cmake").string();
    const auto values = (folder_ / "values.hpp").string();
    output_of("cmake -D source='" + tree_.string() + "' -D output='" + values + "' -D code_version=1.2.3 " +
              "-D 'compiler_flags=-D \"x\"' -P '" + script + "' 2>&1");
    return output_of("cat '" + values + "'");
  }
  void SetUp() override { std::filesystem::create_directory(tree_); }

  const TemporaryFolder folder_;
  const std::filesystem::path tree_ = folder_ / "tree";
};

TEST_F(BuildInformation, OfASourceArchiveIsUnknown) {
  const auto text = run();
  EXPECT_NE(text.find("git_revision = \"unknown\""), std::string::npos) << text;
  EXPECT_NE(text.find("git_state = \"unknown: the source is no git checkout\""), std::string::npos) << text;
  EXPECT_NE(text.find("paper_doi = \"unknown\""), std::string::npos) << text;
  EXPECT_NE(text.find("compiler_flags = \"-D \\\"x\\\"\""), std::string::npos) << text;
}

TEST_F(BuildInformation, TellsACleanTreeFromADirtyOne) {
  const std::string git = "git -C " + tree_.string() + " -c user.name=a -c user.email=a@b ";
  output_of("git init -q " + tree_.string());
  std::ofstream(tree_ / "main.cpp") << "int x;\n";
  output_of(git + "add -A && " + git + "commit -q -m first");
  auto text = run();
  EXPECT_NE(text.find(output_of(git + "rev-parse HEAD")), std::string::npos) << text;
  EXPECT_NE(text.find("git_state = \"clean\""), std::string::npos) << text;
  std::ofstream(tree_ / "new.cpp") << "int y;\n";
  text = run();
  EXPECT_NE(text.find("git_state = \"dirty\""), std::string::npos) << text;
}

TEST_F(BuildInformation, SaysWhyGitDoesNotTellARevision) {
  std::filesystem::create_directory(tree_ / ".git");
  const auto text = run();
  EXPECT_NE(text.find("git_revision = \"unknown\""), std::string::npos) << text;
  EXPECT_NE(text.find("git_state = \"unknown: git says: fatal: "), std::string::npos) << text;
}

TEST_F(BuildInformation, ReadsTheCheckoutOfAnotherUser) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  const std::string git = "git -C " + tree_.string() + " -c user.name=a -c user.email=a@b ";
  output_of("git init -q " + tree_.string() + " && " + git + "commit -q --allow-empty -m first");
  const std::string revision = output_of(git + "rev-parse HEAD");
  output_of("chown -R 65534 " + tree_.string());
  ASSERT_NE(output_of("env -u SUDO_UID " + git + "rev-parse HEAD 2>&1").find("dubious ownership"), std::string::npos);
  const auto text = run();
  EXPECT_NE(text.find("git_revision = \"" + revision + "\""), std::string::npos) << text;
  EXPECT_NE(text.find("git_state = \"clean\""), std::string::npos) << text;
}

TEST_F(BuildInformation, TakesTheDoiOfTheFirstReferenceOnly) {
  const std::string head = "doi: 10.5281/software\nreferences:\n  # comment - with doi: 10.1/no\n  - type: article\n"
                           "    authors:\n      - family-names: A\n";
  const std::string second = "  - type: article\n    doi: 10.1/other\n";
  std::ofstream(tree_ / "CITATION.cff") << head << second;
  EXPECT_NE(run().find("paper_doi = \"unknown\""), std::string::npos) << run();
  std::ofstream(tree_ / "CITATION.cff") << head << "    doi: \"10.1002/example.1\"\n" << second;
  EXPECT_NE(run().find("paper_doi = \"10.1002/example.1\""), std::string::npos) << run();
  std::ofstream(tree_ / "CITATION.cff") << head << "    doi: 10.1002/example.2\n";
  EXPECT_NE(run().find("paper_doi = \"10.1002/example.2\""), std::string::npos) << run();
  std::ofstream(tree_ / "CITATION.cff") << "doi: 10.5281/software\n";
  EXPECT_NE(run().find("paper_doi = \"unknown\""), std::string::npos) << run();
}

}  // namespace
}  // namespace flowslide
