// SPDX-License-Identifier: GPL-2.0-or-later
// Verdicts as text for a terminal, for README and for programs.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "claims/claims.hpp"

namespace flowslide {
namespace {

/// A cell of a Markdown table: escapes bars and what would be a tag of HTML, such as "<tau>", and replaces line breaks
/// by blanks.
std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_tag = text[i] == '<' && i + 1 < text.size() && text[i + 1] != ' ' && text[i + 1] != '=';
    if (text[i] == '|') cell += '\\';
    if (begins_tag) cell += "&lt;";
    else cell += text[i] == '\n' ? ' ' : text[i];
  }
  return cell;
}

}  // namespace

std::string Verdict::measurement() const {
  if (!std::isfinite(measured)) return "-";
  return fmt::format("{:.4g}{}", measured, claim.unit == "1" ? "" : " " + claim.unit);
}

std::string terminal_table(const std::vector<Verdict>& verdicts) {
  using Row = std::array<std::string, 5>;
  std::vector<Row> rows{{"", "figure", "claim", "expected", "measured"}};
  for (const Verdict& verdict : verdicts) {
    rows.push_back({verdict.ruling == Ruling::not_met ? "NOT MET" : std::string(name_of(verdict.ruling)),
                    verdict.claim.figure, verdict.claim.id, verdict.claim.expectation(), verdict.measurement()});
  }
  std::array<std::size_t, 5> widths{};
  for (const Row& row : rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      widths[column] = std::max(widths[column], row[column].size());
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::string line;
    for (std::size_t column = 0; column < widths.size(); ++column)
      line += fmt::format("{:<{}}  ", rows[i][column], widths[column]);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
    if (i == 0 || verdicts[i - 1].ruling == Ruling::met) continue;
    const Verdict& verdict = verdicts[i - 1];
    const bool repeated = i > 1 && verdict.reason == verdicts[i - 2].reason;  // print a common reason once
    text += fmt::format("         {}({})\n", repeated ? "" : verdict.reason + " ", verdict.claim.sentence);
  }
  return text;
}

std::string markdown_table(const std::vector<Verdict>& verdicts) {
  std::string text =
      "| Figure | The paper says | Expected | Measured | Verdict | Origin of the tolerance |\n"
      "|---|---|---|---|---|---|\n";
  for (const Verdict& verdict : verdicts) {
    const std::string_view name = name_of(verdict.ruling);
    const std::string word =
        verdict.ruling == Ruling::met ? std::string(name) : fmt::format("**{}**: {}", name, verdict.reason);
    text += fmt::format(
        "| {} | {} | {} | {} | {} | {} |\n", markdown_cell(verdict.claim.figure), markdown_cell(verdict.claim.sentence),
        markdown_cell(fmt::format("`{}` {}", verdict.claim.metric, verdict.claim.expectation())),
        markdown_cell(verdict.measurement()), markdown_cell(word), markdown_cell(verdict.claim.origin));
  }
  return text;
}

std::string json(const std::vector<Verdict>& verdicts) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Verdict& verdict : verdicts) {
    const Claim& claim = verdict.claim;
    nlohmann::ordered_json met;  // null
    if (verdict.ruling != Ruling::not_evaluated) met = verdict.ruling == Ruling::met;
    all.push_back({{"id", claim.id},
                   {"figure", claim.figure},
                   {"sentence", claim.sentence},
                   {"metric", claim.metric},
                   {"relation", symbol_of(claim.relation)},
                   {"threshold", claim.threshold},
                   {"upper_threshold", claim.upper_threshold},
                   {"unit", claim.unit},
                   {"origin", claim.origin},
                   {"measured", verdict.measured},
                   {"met", met},
                   {"reason", verdict.reason}});
  }
  return all.dump(1) + "\n";
}

}  // namespace flowslide
