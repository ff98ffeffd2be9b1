// SPDX-License-Identifier: GPL-2.0-or-later
#include "claims/claims.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "configuration/configuration.hpp"

namespace flowslide {
namespace {

const std::vector<std::pair<std::string, Relation>> relations{{"<", Relation::less},
                                                              {"<=", Relation::at_most},
                                                              {">", Relation::greater},
                                                              {">=", Relation::at_least},
                                                              {"between", Relation::between}};

bool is_name(const std::string& text) {
  const auto allowed = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
  return !text.empty() && std::all_of(text.begin(), text.end(), allowed);
}

void read_thresholds(const Configuration& configuration, const std::string& key, Claim& claim) {
  const std::vector<double> thresholds = configuration.numbers(key);
  const std::size_t wanted = claim.relation == Relation::between ? 2 : 1;
  if (thresholds.size() != wanted) {
    configuration.refuse(key,
                         fmt::format("has {} value(s), but the relation \"{}\" needs {}", thresholds.size(),
                                     symbol_of(claim.relation), wanted),
                         wanted == 2 ? "write [lower, upper]" : "write one number");
  }
  claim.threshold = thresholds.front();
  claim.upper_threshold = thresholds.back();
  if (claim.threshold > claim.upper_threshold)
    configuration.refuse(key, "has its upper bound below its lower one", "write [lower, upper]");
}

Claim read_claim(const Configuration& configuration, const std::string& prefix) {
  Claim claim;
  claim.id = configuration.text(prefix + "id");
  if (!is_name(claim.id)) {
    configuration.refuse(prefix + "id", "is not a name, but it names a test",
                         "use letters, digits, \"_\" and \"-\" only");
  }
  claim.figure = configuration.text(prefix + "figure");
  claim.sentence = configuration.text(prefix + "sentence");
  claim.metric = configuration.text(prefix + "metric");
  claim.relation = configuration.choice(prefix + "relation", relations);
  read_thresholds(configuration, prefix + "threshold", claim);
  claim.unit = configuration.text(prefix + "unit");
  claim.origin = configuration.text(prefix + "origin");
  if (configuration.has(prefix + "scales")) claim.scales = configuration.texts(prefix + "scales", {"quick", "paper"});
  return claim;
}

bool holds(const Claim& claim, double measured) {
  switch (claim.relation) {
    case Relation::less:
      return measured < claim.threshold;
    case Relation::at_most:
      return measured <= claim.threshold;
    case Relation::greater:
      return measured > claim.threshold;
    case Relation::at_least:
      return measured >= claim.threshold;
    case Relation::between:
      return measured >= claim.threshold && measured <= claim.upper_threshold;
  }
  return false;
}

Verdict judge(const Claim& claim, const std::map<std::string, double>& metrics) {
  Verdict verdict{.claim = claim, .reason = {}};
  const auto found = metrics.find(claim.metric);
  if (found == metrics.end()) {
    verdict.reason = fmt::format("the metric \"{}\" was not measured", claim.metric);
    return verdict;
  }
  verdict.measured = found->second;
  if (!std::isfinite(verdict.measured)) {
    verdict.reason = fmt::format("the metric \"{}\" is {}, not a finite number", claim.metric, verdict.measured);
    return verdict;
  }
  const bool met = holds(claim, verdict.measured);
  verdict.ruling = met ? Ruling::met : Ruling::not_met;
  verdict.reason = fmt::format("{:.4g} is {}{}", verdict.measured, met ? "" : "not ", claim.expectation());
  return verdict;
}

/// Whether a name ends like that of a further replicate: "_r2".
bool is_replicate_ending(std::string_view ending) {
  return ending.starts_with("_r") && ending.size() > 2 &&
         ending.find_first_not_of("0123456789", 2) == std::string_view::npos;
}

}  // namespace

std::string_view symbol_of(Relation relation) {
  for (const auto& [symbol, other] : relations)
    if (other == relation) return symbol;
  throw std::invalid_argument("a relation without a symbol");
}

Relation relation_of(std::string_view symbol) {
  for (const auto& [other, relation] : relations)
    if (other == symbol) return relation;
  throw std::invalid_argument(fmt::format("a claim has the relation \"{}\", which is not known", symbol));
}

std::string Claim::expectation() const {
  const std::string suffix = unit == "1" ? "" : " " + unit;
  if (relation == Relation::between) return fmt::format("between {} and {}{}", threshold, upper_threshold, suffix);
  return fmt::format("{} {}{}", symbol_of(relation), threshold, suffix);
}

bool ClaimsFile::is_figure_only(std::string_view run) const {
  return std::any_of(figure_only.begin(), figure_only.end(), [&](const std::string& name) {
    return run == name || (run.starts_with(name) && is_replicate_ending(run.substr(name.size())));
  });
}

std::set<std::string> figures_in(const std::string& text) {
  std::set<std::string> figures;
  if (!text.starts_with("Fig")) return figures;
  for (std::size_t start = text.find(' '); start != std::string::npos; start = text.find(' ', start)) {
    const std::size_t end = text.find(' ', ++start);
    std::string word = text.substr(start, end == std::string::npos ? end : end - start);
    if (!word.empty() && std::isdigit(static_cast<unsigned char>(word.front())) != 0)
      while (std::isupper(static_cast<unsigned char>(word.back())) != 0) word.pop_back();
    figures.insert(word);
  }
  return figures;
}

ClaimsFile load_claims(const std::filesystem::path& file) {
  return load_claims(Configuration(Layers{.case_file = file, .scale = {}, .user_file = {}, .overrides = {}}));
}

ClaimsFile load_claims(const Configuration& configuration) {
  ClaimsFile file;
  std::set<std::string> ids;
  for (const std::string& position : configuration.subtables("claim")) {
    const std::string prefix = "claim." + position + ".";
    file.claims.push_back(read_claim(configuration, prefix));
    if (!ids.insert(file.claims.back().id).second)
      configuration.refuse(prefix + "id", "stands there twice", "give each claim an id of its own");
  }
  if (configuration.has("figure_only")) file.figure_only = configuration.texts("figure_only");
  configuration.reject_unknown();
  return file;
}

std::vector<Claim> claims_at(const std::vector<Claim>& claims, std::string_view scale) {
  std::vector<Claim> chosen;
  for (const Claim& claim : claims) {
    const bool everywhere = claim.scales.empty();
    if (everywhere || std::find(claim.scales.begin(), claim.scales.end(), scale) != claim.scales.end())
      chosen.push_back(claim);
  }
  return chosen;
}

std::vector<Verdict> evaluate(const std::vector<Claim>& claims, const std::map<std::string, double>& metrics) {
  std::vector<Verdict> verdicts;
  verdicts.reserve(claims.size());
  for (const Claim& claim : claims) verdicts.push_back(judge(claim, metrics));
  return verdicts;
}

std::vector<Verdict> not_evaluated(std::vector<Verdict> verdicts, const std::string& reason) {
  for (Verdict& verdict : verdicts) {
    verdict.ruling = Ruling::not_evaluated;
    verdict.reason = reason;
  }
  return verdicts;
}

bool is_one_not_met(const std::vector<Verdict>& verdicts) {
  return std::any_of(verdicts.begin(), verdicts.end(),
                     [](const Verdict& verdict) { return verdict.ruling == Ruling::not_met; });
}

std::string_view name_of(Ruling ruling) {
  return ruling == Ruling::met ? "met" : ruling == Ruling::not_met ? "not met" : "not evaluated";
}

}  // namespace flowslide
