// SPDX-License-Identifier: GPL-2.0-or-later
// Claims of the paper as numbers that a run meets or does not meet: the file claims.toml of each case.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

class Configuration;

/// Required relation of a measured number to a threshold.
enum class Relation { less, at_most, greater, at_least, between };

/// "<", "<=", ">", ">=", "between".
std::string_view symbol_of(Relation relation);
/// The relation of a symbol. Throws std::invalid_argument for any other text.
Relation relation_of(std::string_view symbol);

/// One claim of the paper. In claims.toml: a table [[claim]] with keys of the same names.
struct Claim {
  std::string id;        ///< unique in its file: letters, digits, "_" and "-"; also the name of the test
  std::string figure;    ///< "Fig. 3A"
  std::string sentence;  ///< statement of the paper
  std::string metric;    ///< name of the measured number
  Relation relation = Relation::less;
  double threshold = 0.0;           ///< the bound; the lower bound for `between`
  double upper_threshold = 0.0;     ///< the upper bound for `between` (both inclusive); otherwise equal to threshold
  std::string unit;                 ///< unit of metric and thresholds; "1" if dimensionless
  std::string origin;               ///< origin of the tolerance: "rounding", "scheme order", "replicate spread",
                                    ///< "published"
  std::vector<std::string> scales;  ///< scales at which the claim holds; empty: all

  /// "< 1 %", "between 0.79 and 0.81".
  std::string expectation() const;
};

/// Verdict on a claim. `not_evaluated`: its number was not measured, or the run had other settings.
enum class Ruling { met, not_met, not_evaluated };

/// "met", "not met", "not evaluated".
std::string_view name_of(Ruling ruling);

/// A claim with its measured number.
struct Verdict {
  Claim claim;
  double measured = std::numeric_limits<double>::quiet_NaN();  ///< in the unit of the claim; NaN if missing
  Ruling ruling = Ruling::not_evaluated;
  std::string reason;  ///< one clause: the comparison, or why the claim is not evaluated

  /// "0.0871 Pa"; "-" if the number is missing or not finite.
  std::string measurement() const;
};

/// What claims.toml says of a case.
struct ClaimsFile {
  std::vector<Claim> claims;
  /// Slides or replicates that are there for a figure alone at quick scale: no claim needs them, and the tests of the
  /// claims do not run them. The name of a slide stands for all its replicates.
  std::vector<std::string> figure_only;

  /// Whether a run, such as "RI_4kPa_r2", or its slide is in figure_only.
  bool is_figure_only(std::string_view run) const;
};

/// Reads claims.toml. Throws ConfigurationError with the line for every error, unknown keys included.
ClaimsFile load_claims(const std::filesystem::path& file);
/// The same from a configuration that holds only claims.
ClaimsFile load_claims(const Configuration& configuration);

/// The claims that hold at `scale`.
std::vector<Claim> claims_at(const std::vector<Claim>& claims, std::string_view scale);

/// One verdict per claim, in order. A claim whose metric is missing or not finite is not evaluated; the reason says so.
std::vector<Verdict> evaluate(const std::vector<Claim>& claims, const std::map<std::string, double>& metrics);

/// The same verdicts and measured numbers, but all `not_evaluated` for the same `reason`.
std::vector<Verdict> not_evaluated(std::vector<Verdict> verdicts, const std::string& reason);

/// Whether at least one claim is evaluated and not met.
bool is_one_not_met(const std::vector<Verdict>& verdicts);

/// The figures that a claim's `figure` names, without the letters of panels: {"6", "7"} for "Figs. 6C and 7C",
/// {"speed_error"} for "Fig. speed_error"; none for a section.
std::set<std::string> figures_in(const std::string& text);

/// Table for a terminal, with aligned columns: `met`, `NOT MET` or `not evaluated`; figure; claim; expected; measured.
/// Below each claim that is not met or not evaluated: the reason and the statement of the paper.
std::string terminal_table(const std::vector<Verdict>& verdicts);
/// Table for README: figure, statement of the paper, expected, measured, verdict, origin of the tolerance.
std::string markdown_table(const std::vector<Verdict>& verdicts);
/// An array of JSON objects. "met" is true, false, or null if the claim is not evaluated. A number that is not finite
/// is null.
std::string json(const std::vector<Verdict>& verdicts);

}  // namespace flowslide
