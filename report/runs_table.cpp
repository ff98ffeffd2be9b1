// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/runs_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "process/progress.hpp"
#include "report/markup.hpp"
#include "run/cost.hpp"

namespace flowslide {
namespace {

std::string code_state(const Provenance& provenance) {
  const std::string revision = provenance.git_revision.substr(0, 10);
  return provenance.git_state == "clean" ? revision : revision + " (" + provenance.git_state + ")";
}

std::string files_of(const Run& run, const std::filesystem::path& folder) {
  std::string links = fmt::format("<a href=\"{}\">HDF5</a>", link_from(folder, run.file));
  std::filesystem::path table = run.file;
  if (std::filesystem::exists(table.replace_extension(".dat")))
    links += fmt::format(" <a href=\"{}\">table</a>", link_from(folder, table));
  return links;
}

std::string row(const Run& run, const std::filesystem::path& folder) {
  if (!run.problem.empty())
    return fmt::format("<tr><th scope=\"row\">{}</th><td colspan=\"9\" class=\"problem\">{}</td></tr>\n",
                       escaped(run.file.filename().string()), escaped(run.problem));
  const Provenance& from = run.provenance;
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{} {}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td>{}</td><td><code>{:.10}</code></td><td><code>{}</code></td>"
      "<td class=\"small\">{}</td></tr>\n",
      escaped(from.point), files_of(run, folder), escaped(from.engine), escaped(from.engine_version), from.seed,
      from.mpi_ranks, std::isfinite(from.processor_seconds) ? duration_text(from.processor_seconds) : "",
      escaped(from.start_time), escaped(run.configuration_hash), escaped(code_state(from)), escaped(run.sample));
}

/// Compilers, hosts and commands of the runs, each different one once.
std::string origins(const std::vector<Run>& runs) {
  std::set<std::string> builds, commands;
  for (const Run& run : runs) {
    if (!run.problem.empty()) continue;
    const Provenance& from = run.provenance;
    builds.insert(fmt::format("flowslide {}, {} {} ({}), host {}", from.code_version, from.compiler,
                              from.compiler_flags, from.build_type, from.host));
    commands.insert(from.command_line);
  }
  std::string html;
  for (const std::string& build : builds) html += fmt::format("<p class=\"small\">{}</p>\n", escaped(build));
  html += "<pre>";
  for (const std::string& command : commands) html += escaped(command) + "\n";
  return html + "</pre>\n";
}

}  // namespace

std::string runs_table(const std::vector<Run>& runs, const std::filesystem::path& folder) {
  std::string html =
      "<div class=\"wide\"><table class=\"runs\"><thead><tr><th scope=\"col\">Run</th><th scope=\"col\">Data</th>"
      "<th scope=\"col\">Engine</th><th scope=\"col\" class=\"number\">Seed</th>"
      "<th scope=\"col\" class=\"number\">Ranks</th><th scope=\"col\" class=\"number\">Processor time</th><th "
      "scope=\"col\">Started (UTC)</th>"
      "<th scope=\"col\">Configuration</th><th scope=\"col\">Code</th><th "
      "scope=\"col\">Sample</th></tr></thead><tbody>\n";
  std::vector<Provenance> points;
  for (const Run& run : runs) {
    html += row(run, folder);
    if (run.problem.empty()) points.push_back(run.provenance);
  }
  return html + fmt::format("</tbody></table></div>\n<p>{}</p>\n", escaped(cost_text(cost_of(points)))) + origins(runs);
}

}  // namespace flowslide
