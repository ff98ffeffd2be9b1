// SPDX-License-Identifier: GPL-2.0-or-later
// Verdicts as text: for a terminal, for README, for programs and for gnuplot.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "claims/claims.hpp"

namespace flowslide {
namespace {

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      quoted += '\\';
      quoted += c;
    } else if (byte < 0x20) {
      quoted += fmt::format("\\u{:04x}", byte);
    } else {
      quoted += c;
    }
  }
  return quoted + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

const char* json_met(Ruling ruling) {
  return ruling == Ruling::met ? "true" : ruling == Ruling::not_met ? "false" : "null";
}
const char* data_met(Ruling ruling) { return ruling == Ruling::met ? "1" : ruling == Ruling::not_met ? "0" : "NaN"; }

/// A cell of a Markdown table: no bar ends it early, no line break ends the row.
std::string markdown_cell(std::string_view text) {
  std::string cell;
  for (const char c : text) {
    if (c == '|') cell += '\\';
    cell += c == '\n' ? ' ' : c;
  }
  return cell;
}

/// A field of a table of columns: quotes would end it early.
std::string data_text(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  std::replace(text.begin(), text.end(), '\n', ' ');
  return '"' + text + '"';
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
    const bool said = i > 1 && verdict.reason == verdicts[i - 2].reason;  // once for all that share it
    text += fmt::format("         {}({})\n", said ? "" : verdict.reason + " ", verdict.claim.sentence);
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
  std::string text = "[";
  for (const Verdict& verdict : verdicts) {
    const Claim& claim = verdict.claim;
    text += text.size() == 1 ? "\n" : ",\n";
    text += fmt::format("  {{\"id\": {}, \"figure\": {}, \"sentence\": {}, \"metric\": {}, \"relation\": {}, ",
                        json_text(claim.id), json_text(claim.figure), json_text(claim.sentence),
                        json_text(claim.metric), json_text(symbol_of(claim.relation)));
    text += fmt::format("\"threshold\": {}, \"upper_threshold\": {}, \"unit\": {}, \"origin\": {}, ",
                        json_number(claim.threshold), json_number(claim.upper_threshold), json_text(claim.unit),
                        json_text(claim.origin));
    text += fmt::format("\"measured\": {}, \"met\": {}, \"reason\": {}}}", json_number(verdict.measured),
                        json_met(verdict.ruling), json_text(verdict.reason));
  }
  return text + (verdicts.empty() ? "]\n" : "\n]\n");
}

std::string data_table(const std::vector<Verdict>& verdicts) {
  std::string text = "# id measured threshold upper_threshold unit met figure sentence\n";
  for (const Verdict& verdict : verdicts) {
    const Claim& claim = verdict.claim;
    text += fmt::format("{} {} {} {} {} {} {} {}\n", data_text(claim.id), verdict.measured, claim.threshold,
                        claim.upper_threshold, data_text(claim.unit), data_met(verdict.ruling), data_text(claim.figure),
                        data_text(claim.sentence));
  }
  return text;
}

}  // namespace flowslide
