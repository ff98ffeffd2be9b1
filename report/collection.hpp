// SPDX-License-Identifier: GPL-2.0-or-later
// The results of a project, read from its folders.
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
  std::filesystem::path picture;   ///< PNG file; empty if it does not exist
};

/// One run, read from its HDF5 file.
struct Run {
  std::filesystem::path file;
  Provenance provenance = {};
  std::string configuration_hash = {};
  std::string sample = {};         ///< health of its sample, see record/health_line.hpp
  std::string problem = {};        ///< why the file could not be read; empty if the other members are valid
};

struct CaseResults {
  std::string name;                ///< "fig03_undrained"
  std::string readme = {};         ///< README of the case, Markdown
  std::filesystem::path folder = {};  ///< folder of the results; may be absent
  std::vector<Figure> figures = {};
  std::vector<Verdict> verdicts = {};
  std::vector<std::filesystem::path> tables = {};  ///< Markdown tables of the case; <table>.h5 has the numbers
  std::vector<Run> runs = {};

  bool empty() const { return verdicts.empty() && tables.empty() && runs.empty(); }
};

/// The verdicts in a file claims.json (see json() in claims/claims.hpp). Throws std::invalid_argument for any other
/// text.
std::vector<Verdict> verdicts_from_json(std::string_view text);

/// All cases of `project` with their results in `results`/<case>/<scale>. Cases with figures come first; all are sorted
/// by name. Reads cases/ and plots/figures.txt of the project; throws FileError, std::filesystem::filesystem_error or
/// ConfigurationError if they are missing or do not match.
std::vector<CaseResults> collect_results(const std::filesystem::path& project, const std::filesystem::path& results,
                                         const std::string& scale);

}  // namespace flowslide
