// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/collection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "configuration/error.hpp"
#include "record/atomic_file.hpp"
#include "record/health_line.hpp"
#include "record/result_file.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view own_studies = "study";  ///< the case of the user's own studies; the page leaves it out

/// Files of a folder with this ending, sorted by name; none if the folder is absent.
std::vector<fs::path> files_with(const fs::path& folder, std::string_view ending) {
  std::vector<fs::path> files;
  if (!fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ending) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

Run read_run(const fs::path& file) {
  Run run{.file = file};
  try {
    const Result result = read_result(file);
    run.provenance = result.provenance;
    run.configuration_hash = result.configuration_hash;
    run.sample = health_line(result.metrics);
  } catch (const FileError& error) {
    run.problem = error.what();
  }
  return run;
}

CaseResults read_case(const fs::path& project, const fs::path& results, const std::string& name,
                      const std::string& scale) {
  CaseResults found{.name = name, .folder = results / name / scale};
  if (const fs::path readme = project / "cases" / name / "README.md"; fs::exists(readme))
    found.readme = read_file(readme);
  for (const fs::path& file : files_with(found.folder, ".h5"))
    if (!fs::exists(fs::path(file).replace_extension(".md"))) found.runs.push_back(read_run(file));
  for (const fs::path& file : files_with(found.folder, ".md"))
    if (file.filename() != "claims.md") found.tables.push_back(file);
  if (const fs::path claims = found.folder / "claims.json"; fs::exists(claims)) {
    try {
      found.verdicts = verdicts_from_json(read_file(claims));
    } catch (const std::invalid_argument& error) {
      throw ConfigurationError(fmt::format("{}: {}; run ./reproduce again", claims.string(), error.what()));
    }
  }
  return found;
}

CaseResults& case_named(std::vector<CaseResults>& cases, const std::string& name) {
  const auto found = std::find_if(cases.begin(), cases.end(), [&](const CaseResults& a) { return a.name == name; });
  if (found == cases.end()) throw ConfigurationError(fmt::format("plots/figures.txt names the unknown case {}", name));
  return *found;
}

/// Adds pictures that figures.txt does not list, such as those of a case beyond the paper.
void add_other_pictures(CaseResults& the_case) {
  for (const fs::path& picture : files_with(the_case.folder, ".png")) {
    const std::string name = picture.stem().string();
    if (std::none_of(the_case.figures.begin(), the_case.figures.end(), [&](const Figure& f) { return f.name == name; }))
      the_case.figures.push_back({name, "", picture});
  }
}

}  // namespace

std::vector<Verdict> verdicts_from_json(std::string_view text) {
  try {
    std::vector<Verdict> verdicts;
    for (const nlohmann::json& entry : nlohmann::json::parse(text)) {
      Verdict verdict;
      const auto string = [&](const char* key) { return entry.at(key).get<std::string>(); };
      const auto number = [&](const char* key) {   // null stands for a number that is not finite
        const nlohmann::json& value = entry.at(key);
        return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
      };
      verdict.claim = {.id = string("id"),
                       .figure = string("figure"),
                       .sentence = string("sentence"),
                       .metric = string("metric"),
                       .relation = relation_of(string("relation")),
                       .threshold = number("threshold"),
                       .upper_threshold = number("upper_threshold"),
                       .unit = string("unit"),
                       .origin = string("origin"),
                       .scales = {}};
      verdict.measured = number("measured");
      const nlohmann::json& met = entry.at("met");  // null if the claim is not evaluated
      verdict.ruling = met.is_null() ? Ruling::not_evaluated : met.get<bool>() ? Ruling::met : Ruling::not_met;
      verdict.reason = string("reason");
      verdicts.push_back(verdict);
    }
    return verdicts;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(fmt::format("it is no list of verdicts: {}", error.what()));
  }
}

std::vector<CaseResults> collect_results(const fs::path& project, const fs::path& results, const std::string& scale) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(project / "cases"))
    if (fs::exists(entry.path() / "case.toml") && entry.path().filename() != own_studies)
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  std::vector<CaseResults> cases;
  cases.reserve(names.size());
  for (const std::string& name : names) cases.push_back(read_case(project, results, name, scale));

  std::istringstream lines(read_file(project / "plots" / "figures.txt"));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string figure, name, script, title;
    if (line.starts_with('#') || !(words >> figure >> name >> script) || name == own_studies) continue;
    std::getline(words >> std::ws, title);
    CaseResults& owner = case_named(cases, name);
    const fs::path picture = owner.folder / (figure + ".png");
    owner.figures.push_back({figure, title, fs::exists(picture) ? picture : fs::path()});
  }
  std::stable_partition(cases.begin(), cases.end(), [](const CaseResults& a) { return !a.figures.empty(); });
  for (CaseResults& the_case : cases) add_other_pictures(the_case);
  return cases;
}

}  // namespace flowslide
