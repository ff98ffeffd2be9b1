// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "record/atomic_file.hpp"
#include "report/markup.hpp"
#include "report/runs_table.hpp"

namespace flowslide {
namespace {

std::size_t count_of(const std::vector<Verdict>& verdicts, Ruling ruling) {
  return static_cast<std::size_t>(
      std::count_if(verdicts.begin(), verdicts.end(), [&](const auto& v) { return v.ruling == ruling; }));
}
std::size_t drawn(const std::vector<Figure>& figures) {
  return static_cast<std::size_t>(
      std::count_if(figures.begin(), figures.end(), [](const auto& f) { return !f.picture.empty(); }));
}

std::string title_of(const CaseResults& results) {
  const std::string title = first_heading(results.readme);
  return title.empty() ? results.name : title;
}

/// The command that makes the results of a case again.
std::string command_of(const CaseResults& results, const std::string& options) {
  std::string figures;
  for (const Figure& figure : results.figures)
    if (!figure.title.empty()) figures += " " + figure.name;
  const std::string program = fmt::format("build/release/cases/{0}/{0}", results.name);
  return (figures.empty() ? program : "./reproduce" + figures) + (options.empty() ? "" : " " + options);
}

/// A verdict as word, sign and colour: it is readable without colours.
std::string verdict_mark(Ruling ruling, std::string_view word) {
  const bool is_met = ruling == Ruling::met, is_open = ruling == Ruling::not_evaluated;
  return fmt::format("<span class=\"mark {}\"><span aria-hidden=\"true\">{}</span> {}</span>",
                     is_met    ? "met"
                     : is_open ? "open"
                               : "missed",
                     is_met    ? "&#10003;"
                     : is_open ? "&#8211;"
                               : "&#10007;",
                     word);
}

std::string claims_table(const std::vector<Verdict>& verdicts) {
  std::string html =
      "<div class=\"wide\"><table class=\"claims\"><thead><tr><th scope=\"col\">Verdict</th>"
      "<th scope=\"col\">Figure</th><th scope=\"col\">The paper says</th><th scope=\"col\">Expected</th>"
      "<th scope=\"col\">Measured</th><th scope=\"col\">Origin of the tolerance</th></tr></thead><tbody>\n";
  for (const Verdict& verdict : verdicts) {
    const Claim& claim = verdict.claim;
    html += fmt::format(
        "<tr><td>{}</td><td class=\"value\">{}</td><td>{}<br><code>{}</code></td><td class=\"value\">{}</td>"
        "<td class=\"value\">{}</td>"
        "<td class=\"small\">{}</td></tr>\n",
        verdict_mark(verdict.ruling, name_of(verdict.ruling)), escaped(claim.figure), escaped(claim.sentence),
        escaped(claim.metric), escaped(claim.expectation()), escaped(verdict.measurement()), escaped(claim.origin));
  }
  return html + "</tbody></table></div>\n";
}

/// "Fig. 3" for "fig03", with the number in the paper; other names do not change.
std::string printed_name(const std::string& name) {
  int number = 0;
  const char* const end = name.data() + name.size();
  const bool numbered = name.starts_with("fig") && std::from_chars(name.data() + 3, end, number).ptr == end;
  return numbered ? fmt::format("Fig. {}", number) : name;
}

std::string figure_html(const Figure& figure, const std::filesystem::path& folder) {
  const std::string caption = figure.title.empty() ? figure.name : printed_name(figure.name) + ": " + figure.title;
  std::filesystem::path document = figure.picture;
  std::string link;
  if (std::filesystem::exists(document.replace_extension(".pdf")))
    link = fmt::format(" <a href=\"{}\">PDF</a>", link_from(folder, document));
  return fmt::format(
      "<figure id=\"{0}\"><div class=\"wide\"><img src=\"{1}\" alt=\"{2}\"></div>"
      "<figcaption>{2}{3}</figcaption></figure>\n",
      escaped(figure.name), data_url(figure.picture, "image/png"), escaped(caption), link);
}

std::string table_html(const std::filesystem::path& table, const std::filesystem::path& folder) {
  std::string html = fmt::format("<div class=\"wide table\">\n{}</div>\n", html_of_markdown(read_file(table)));
  std::filesystem::path numbers = table;
  if (std::filesystem::exists(numbers.replace_extension(".h5")))
    html += fmt::format("<p class=\"small\"><a href=\"{}\">HDF5</a> of this table</p>\n", link_from(folder, numbers));
  return html;
}

std::string folded(const std::string& title, const std::string& content) {
  if (content.empty()) return "";
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", escaped(title), content);
}

/// The command of a case without results, folded.
std::string not_run_html(const CaseResults& results, const PageSetting& setting) {
  return fmt::format(
      "<section id=\"{}\" class=\"case empty\">\n<details><summary>{}: not run at this scale.</summary>\n"
      "<p class=\"command\"><code>{}</code></p>\n</details>\n</section>\n",
      escaped(results.name), escaped(title_of(results)), escaped(command_of(results, setting.options)));
}

std::string case_html(const CaseResults& results, const PageSetting& setting) {
  if (results.empty()) return not_run_html(results, setting);
  std::string html =
      fmt::format("<section id=\"{}\" class=\"case\">\n<h2>{}</h2>\n<p class=\"command\"><code>{}</code></p>\n",
                  escaped(results.name), escaped(title_of(results)), escaped(command_of(results, setting.options)));
  for (const Figure& figure : results.figures)
    if (!figure.picture.empty()) html += figure_html(figure, setting.folder);
  if (!results.verdicts.empty()) html += "<h3>Claims</h3>\n" + claims_table(results.verdicts);
  for (const auto& table : results.tables) html += table_html(table, setting.folder);
  for (const char* title : {"What is done", "Where we differ from the paper, and why"})
    html += folded(title, html_of_markdown(section(results.readme, title)));
  html += folded(fmt::format("Runs and their provenance ({})", results.runs.size()),
                 runs_table(results.runs, setting.folder));
  return html + "</section>\n";
}

/// The claims with this ruling, each with its reason; empty if there are none.
std::string list_of_claims(const std::vector<CaseResults>& cases, Ruling ruling, const char* title) {
  std::string items;
  for (const CaseResults& results : cases)
    for (const Verdict& verdict : results.verdicts)
      if (verdict.ruling == ruling)
        items +=
            fmt::format("<li><a href=\"#{}\">{}</a> {} <span class=\"small\">{}</span></li>\n", escaped(results.name),
                        escaped(verdict.claim.figure), escaped(verdict.claim.sentence), escaped(verdict.reason));
  return items.empty() ? "" : fmt::format("<h3>{}</h3>\n<ul>\n{}</ul>\n", title, items);
}

std::string overview(const std::vector<CaseResults>& cases) {
  std::string html =
      "<section id=\"overview\">\n<h2>Overview</h2>\n<div class=\"wide\"><table><thead><tr><th scope=\"col\">Case</th>"
      "<th scope=\"col\" class=\"number\">Figures</th><th scope=\"col\" class=\"number\">Runs</th>"
      "<th scope=\"col\">Claims</th></tr></thead><tbody>\n";
  for (const CaseResults& results : cases) {
    const std::size_t all = results.verdicts.size(), held = count_of(results.verdicts, Ruling::met);
    const bool missed = count_of(results.verdicts, Ruling::not_met) > 0;
    const Ruling ruling = held == all ? Ruling::met : missed ? Ruling::not_met : Ruling::not_evaluated;
    std::string claims = all == 0 ? "none" : verdict_mark(ruling, fmt::format("{} of {} met", held, all));
    if (results.empty()) claims = "not run";
    html += fmt::format(
        "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th><td class=\"number\">{}</td><td class=\"number\">{}</td>"
        "<td class=\"value\">{}</td></tr>\n",
        escaped(results.name), escaped(title_of(results)), drawn(results.figures), results.runs.size(), claims);
  }
  html += "</tbody></table></div>\n";
  html += list_of_claims(cases, Ruling::not_met, "Claims not met");
  html += list_of_claims(cases, Ruling::not_evaluated, "Claims not evaluated");
  return html + "</section>\n";
}

std::string header(const std::vector<CaseResults>& cases, const std::string& scale) {
  std::size_t claims = 0, claims_met = 0, open = 0, figures = 0, all_figures = 0, runs = 0, not_run = 0;
  for (const CaseResults& results : cases) {
    claims += results.verdicts.size();
    claims_met += count_of(results.verdicts, Ruling::met);
    open += count_of(results.verdicts, Ruling::not_evaluated);
    figures += drawn(results.figures);
    all_figures += results.figures.size();
    not_run += results.empty() ? 1 : 0;
    runs += results.runs.size();
  }
  return fmt::format(
      "<header>\n<h1>Flowslide: a slope that asks grains for its stress</h1>\n"
      "<p>What this code makes of the figures of M. Yang and G. Buscarnera, <cite>Multiscale modeling of granular "
      "dynamics on flowslide triggering and runout</cite>, 2024, at <strong>{}</strong> scale.</p>\n"
      "<dl class=\"counts\"><div><dt>Claims met</dt><dd>{} of {}</dd></div>"
      "<div><dt>Claims not evaluated</dt><dd>{}</dd></div><div><dt>Figures</dt><dd>{} of {}</dd></div>"
      "<div><dt>Runs</dt><dd>{}</dd></div><div><dt>Cases not run</dt><dd>{} of {}</dd></div></dl>\n</header>\n",
      escaped(scale), claims_met, claims, open, figures, all_figures, runs, not_run, cases.size());
}

// Opens all folded sections before printing. Labels each cell with the head of its column, for narrow windows.
constexpr const char* script =
    "addEventListener('beforeprint', () => document.querySelectorAll('details').forEach(d => { d.open = true; }));\n"
    "document.querySelectorAll('table').forEach(t => { const heads = [...t.querySelectorAll('thead th')]; "
    "t.querySelectorAll('tbody tr').forEach(r => [...r.cells].forEach((c, i) => { "
    "if (heads[i]) c.dataset.label = heads[i].textContent; })); });";

}  // namespace

std::string report_page(const std::vector<CaseResults>& cases, const PageSetting& setting) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<link rel=\"icon\" href=\"data:,\">\n"
      "<title>Flowslide, {} scale</title>\n<style>\n{}</style>\n</head>\n<body>\n",
      escaped(setting.scale), setting.style);
  html += header(cases, setting.scale) + "<main>\n" + overview(cases);
  for (const CaseResults& results : cases) html += case_html(results, setting);
  const std::string command = "./reproduce --report" + (setting.options.empty() ? "" : " " + setting.options);
  return html + fmt::format(
                    "</main>\n<footer><p>Written by <code>{}</code> from the files beside it.</p></footer>\n"
                    "<script>{}</script>\n</body>\n</html>\n",
                    escaped(command), script);
}

}  // namespace flowslide
