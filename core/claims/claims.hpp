// SPDX-License-Identifier: GPL-2.0-or-later
// What the paper says, as numbers that a run either meets or does not: claims.toml beside each case.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flowslide {

class Configuration;

/// How a measured number is held against a threshold.
enum class Relation { less, at_most, greater, at_least, between };

/// "<", "<=", ">", ">=", "between".
std::string_view symbol_of(Relation relation);
/// The relation of a symbol. Throws std::invalid_argument for any other text.
Relation relation_of(std::string_view symbol);

/// One claim of the paper. In claims.toml: [[claim]] with the keys of the same names.
struct Claim {
  std::string id;        ///< unique in its file: letters, digits, "_" and "-"; names the test
  std::string figure;    ///< "Fig. 3A"
  std::string sentence;  ///< what the paper says
  std::string metric;    ///< name of the measured number
  Relation relation = Relation::less;
  double threshold = 0.0;           ///< the bound, or the lower of two
  double upper_threshold = 0.0;     ///< the upper bound of `between` (both inclusive); else equal to threshold
  std::string unit;                 ///< of metric and thresholds alike; "1" when dimensionless
  std::string origin;               ///< of the tolerance: "rounding", "scheme order", "replicate spread", "published"
  std::vector<std::string> scales;  ///< at which the claim is made; all when not given

  /// "< 1 %", "between 0.79 and 0.81".
  std::string expectation() const;
};

/// What is said of a claim. Nothing is said of one whose number was not measured, or that other settings were run for.
enum class Ruling { met, not_met, not_evaluated };

/// "met", "not met", "not evaluated".
std::string_view name_of(Ruling ruling);

/// A claim with what was measured.
struct Verdict {
  Claim claim;
  double measured = std::numeric_limits<double>::quiet_NaN();  ///< in the unit of the claim; NaN when missing
  Ruling ruling = Ruling::not_evaluated;
  std::string reason;  ///< one clause: the comparison, or why there is none

  /// "0.0871 Pa"; "-" when nothing was measured.
  std::string measurement() const;
};

/// Reads claims.toml. Throws ConfigurationError with place for whatever is wrong in it, unknown keys too.
std::vector<Claim> load_claims(const std::filesystem::path& file);
/// The same from a configuration that holds nothing else.
std::vector<Claim> load_claims(const Configuration& configuration);

/// Those that are made at a scale.
std::vector<Claim> claims_at(const std::vector<Claim>& claims, std::string_view scale);

/// One verdict per claim, in order. A claim whose metric is missing or not finite is not evaluated; the reason says so.
std::vector<Verdict> evaluate(const std::vector<Claim>& claims, const std::map<std::string, double>& metrics);

/// The same verdicts, with what was measured, where no claim is to be evaluated for one reason.
std::vector<Verdict> not_evaluated(std::vector<Verdict> verdicts, const std::string& reason);

/// Whether a claim is evaluated and not met.
bool is_one_not_met(const std::vector<Verdict>& verdicts);

/// For a terminal: aligned columns `met`, `NOT MET` or `not evaluated`, figure, claim, expected, measured, and the
/// reason of those that are not met.
std::string terminal_table(const std::vector<Verdict>& verdicts);
/// For README: figure, what the paper says, expected, measured, verdict, origin of the tolerance.
std::string markdown_table(const std::vector<Verdict>& verdicts);
/// An array of objects; "met" is true, false, or null if the claim is not evaluated; a number that is not finite is
/// null.
std::string json(const std::vector<Verdict>& verdicts);

}  // namespace flowslide
