// SPDX-License-Identifier: GPL-2.0-or-later
// What the results of a project hold, as read from its folders.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "claims/claims.hpp"
#include "record/provenance.hpp"

namespace flowslide {

struct Figure {
  std::string name;                ///< "fig03"; also the argument of ./reproduce
  std::string title;
  std::filesystem::path picture;   ///< PNG; empty when it was not drawn
};

/// One HDF5 file.
struct Run {
  std::filesystem::path file;
  Provenance provenance = {};
  std::string configuration_hash = {};
  std::string sample = {};         ///< health of its sample, see record/health_line.hpp
  std::string problem = {};        ///< why the file could not be read; empty when all else is valid
};

struct CaseResults {
  std::string name;                ///< "fig03_undrained"
  std::string readme = {};         ///< of the case, Markdown
  std::filesystem::path folder = {};  ///< of the results; need not exist
  std::vector<Figure> figures = {};
  std::vector<Verdict> verdicts = {};
  std::vector<std::filesystem::path> tables = {};  ///< Markdown that the case wrote; <table>.h5 has its numbers
  std::vector<Run> runs = {};

  bool empty() const { return verdicts.empty() && tables.empty() && runs.empty(); }
};

/// The verdicts in a claims.json (see json() of claims/claims.hpp). Throws std::invalid_argument for any other text.
std::vector<Verdict> verdicts_from_json(std::string_view text);

/// Every case of `project` (its cases/ and plots/figures.txt) with its results in `results`/<case>/<scale>: those with
/// figures first, as in figures.txt, then by name. Throws FileError or ConfigurationError for a project without these.
std::vector<CaseResults> collect_results(const std::filesystem::path& project, const std::filesystem::path& results,
                                         const std::string& scale);

}  // namespace flowslide
