// SPDX-License-Identifier: GPL-2.0-or-later
// A project of two cases for the report to read: one with results, one without.
#pragma once
#include "record/atomic_file.hpp"
#include "record/example.hpp"
#include "record/temporary_folder.hpp"

namespace flowslide {

inline constexpr const char* example_claims =
    R"([{"id": "a", "figure": "Fig. 3A", "sentence": "tau <peaks>.", "metric": "peak", "relation": ">", "threshold": 2,
 "upper_threshold": 2, "unit": "kPa", "origin": "published", "measured": 2.5, "met": true, "reason": "2.5 is > 2"},
{"id": "b", "figure": "Fig. 3B", "sentence": "It falls.", "metric": "fall", "relation": "between", "threshold": 1,
 "upper_threshold": 3, "unit": "1", "origin": "published", "measured": null, "met": false, "reason": "not measured"}])";

inline void write_file(const std::filesystem::path& file, const std::string& content) {
  std::filesystem::create_directories(file.parent_path());
  write_atomically(file, content);
}

/// shear: two figures of which one is drawn, a run, a torn one, claims and a table; speed: nothing. No case,
/// and a study of the user's own: ignored.
inline void write_project(const std::filesystem::path& folder) {
  write_file(folder / "plots/figures.txt",
             "# a comment\nfig03  shear  fig03.gp  stress path\nfig04  shear  fig04.gp  two rates\n"
             "study  study  study.gp  a study of your own\n");
  write_file(folder / "cases/shear/case.toml", "");
  write_file(
      folder / "cases/shear/README.md",
      "# Shear & more\n\n## What is done\n\nSee [Fig. 12](../x.md) and [this](https://example.org/).\n\n## Rest\n");
  write_file(folder / "cases/speed/case.toml", "");
  write_file(folder / "cases/study/case.toml", "");
  write_file(folder / "cases/notes.txt", "");
  const auto results = folder / "results/shear/quick";
  write_file(results / "fig03.png", "PNG");
  write_file(results / "fig03.pdf", "PDF");
  write_file(results / "claims.json", example_claims);
  write_file(results / "claims.md", "the same claims\n");
  write_file(results / "table.md", "| N | error |\n|---|---|\n| 8 | 0.5 |\n");
  write_file(results / "table.h5", "numbers of the table");
  write_result(results / "e0_790.h5", example_result());
  write_file(results / "e0_790.dat", "# table\n");
  write_file(results / "torn.h5", "no HDF5");
}

}  // namespace flowslide
