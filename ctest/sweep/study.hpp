// SPDX-License-Identifier: GPL-2.0-or-later
// One random study of a case: its actions and its checks.
#pragma once
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "sweep/study_changes.hpp"

namespace flowslide {

struct StudyFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The program of a case, its points, and the scripts that plot it.
struct CaseUnderTest {
  std::string name;
  std::filesystem::path program;
  std::vector<std::string> engines;  ///< of its studies
  bool has_sweeps;                   ///< the case of the user's own studies
  std::vector<std::string> points;
  std::vector<Setting> settings;
  std::vector<std::pair<std::string, std::filesystem::path>> figures;  ///< name and gnuplot script
};

/// Asks the program of a case for its points and its configuration. The studies of the case `study` run on all engines
/// of the build, those of others on closed-form samples. Throws StudyFailure.
CaseUnderTest case_in(const std::string& name, const std::filesystem::path& build, const std::filesystem::path& source,
                      const std::filesystem::path& room);

/// What was asked for, as options of the program, and why it failed; the reason is empty if all held.
struct StudyOutcome {
  std::string command;
  std::string failure;
};

/// Chooses a study at random, then runs, repeats, changes, collects and plots it in the folder `room`.
StudyOutcome check_study(const CaseUnderTest& of, Dice dice, const std::filesystem::path& room);

}  // namespace flowslide
