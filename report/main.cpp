// SPDX-License-Identifier: GPL-2.0-or-later
// report: writes the results of all cases as one HTML page. ./reproduce --report calls it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "configuration/error.hpp"
#include "process/exit_code.hpp"
#include "program/run_main.hpp"
#include "record/atomic_file.hpp"
#include "report/page.hpp"

namespace {

int write_report(int argc, char** argv) {
  namespace fs = std::filesystem;
  fs::path project = FLOWSLIDE_SOURCE_DIR, results = project / "results", output;
  std::string scale = "quick", options;
  CLI::App app("Writes what the results of all cases hold as one HTML page that needs no network.", "report");
  app.add_option("--project", project, "Folder of the project, with cases/ and plots/")->capture_default_str();
  app.add_option("--results", results, "Folder with <case>/<scale>")->capture_default_str();
  app.add_option("--scale", scale, "Folder within that of a case, such as quick or paper")->capture_default_str();
  app.add_option("--options", options, "What ./reproduce was told to make these results, as the page shall show it");
  app.add_option("--output", output, "The page; default: RESULTS/report-SCALE.html");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw flowslide::FinishedEarly(app.help());
  } catch (const CLI::ParseError& error) {
    throw flowslide::ConfigurationError(fmt::format("{}; see report --help", error.what()));
  }
  if (output.empty()) output = results / ("report-" + scale + ".html");
  const auto cases = flowslide::collect_results(project, results, scale);
  if (std::all_of(cases.begin(), cases.end(), [](const auto& each) { return each.empty(); }))
    throw flowslide::ConfigurationError(fmt::format("{} holds no results at {} scale; run ./reproduce --scale {} first",
                                                    results.string(), scale, scale));
  const std::string style = flowslide::read_file(project / "report" / "style.css");
  const fs::path folder = fs::absolute(output).parent_path();
  flowslide::write_atomically(output, flowslide::report_page(cases, {scale, options, style, folder}));
  std::cout << output.string() << "\n";
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return flowslide::run_main([&] { return write_report(argc, argv); });
}
