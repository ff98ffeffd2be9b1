// SPDX-License-Identifier: GPL-2.0-or-later
#include "sweep_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>

#include "configuration/nearest.hpp"
#include "configuration/symbols.hpp"
#include "configuration/tables.hpp"
#include "input/vocabulary.hpp"
#include "sample/closed_form.hpp"

namespace flowslide {
namespace {

/// The keys of a table that may be swept, and the name of the table in a sweep key.
struct SweepTable {
  std::string name;
  std::set<std::string> keys;
};

/// Keys that are no property of a slope or of a sample. All samples of a study are prepared by one engine.
const std::set<std::string> never{"like", "allow_unstable", "most_trials", "engine"};

/// Keys that change no result, and why.
const std::map<std::string, std::string> idle{
    {"coupling.shear_modulus", "it is only a bound for the limit of dt_G"},
    {"elastic.void_ratio", "the stresses of the elastic sample do not depend on it"}};

/// Keys with one value in these tables, and those that the table may have.
SweepTable keys_of(const Configuration& configuration, const std::string& name,
                   const std::vector<std::string>& tables) {
  SweepTable found{name, {}};
  for (const std::string& table : tables)
    for (const std::string& key : configuration.keys_below(table))
      if (key.find('.') == std::string::npos && !configuration.is_list(table + "." + key)) found.keys.insert(key);
  for (const KeysOfRuns& known : vocabulary())
    if (std::ranges::find(known.tables, name) != known.tables.end())
      found.keys.insert(known.names.begin(), known.names.end());
  for (const std::string& key : never) found.keys.erase(key);
  std::erase_if(found.keys, [&](const std::string& key) { return idle.contains(name + "." + key); });
  return found;
}

std::vector<SweepTable> sweep_tables(const Configuration& configuration, const std::string& engine,
                                     const std::string& sample) {
  std::vector<std::string> coupling{"coupling"};
  for (const std::string& scheme : configuration.subtables("scheme")) coupling.push_back("scheme." + scheme);
  std::vector<SweepTable> tables{keys_of(configuration, "slope", {"slope"}),
                                 keys_of(configuration, "loading", {"loading"}),
                                 keys_of(configuration, "coupling", coupling)};
  if (is_closed_form(engine)) {
    tables.push_back(keys_of(configuration, engine, {engine}));
    return tables;
  }
  tables.push_back(keys_of(configuration, "sample", with_like(configuration, "sample", sample)));
  for (const char* table : {"material", "packing", "preparation"})
    tables.push_back(keys_of(configuration, table, {table}));
  return tables;
}

/// "[slope] (angle, dry_density), [loading] (amplitude)"
std::string list_of_keys(const std::vector<SweepTable>& tables) {
  std::vector<std::string> texts;
  for (const SweepTable& table : tables)
    texts.push_back(fmt::format("[{}] ({})", table.name, fmt::join(table.keys, ", ")));
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// Refuses a key that exists but has no effect in this study: one of another closed-form sample, or an idle one.
void refuse_key_without_effect(const Configuration& configuration, const Sweep& sweep, const std::string& table_asked,
                               const std::string& asked, const std::string& engine) {
  const auto means = [&](const std::string& table) { return table_asked.empty() || table_asked == table; };
  const auto refuse_idle = [&](const std::string& table) {
    if (const auto found = idle.find(table + "." + asked); means(table) && found != idle.end())
      configuration.refuse(sweep.key, "has no effect: " + found->second, "sweep another key");
  };
  refuse_idle(engine);
  for (const std::string& other : closed_form_sample_names())
    if (other != engine && means(other) &&
        (keys_of(configuration, other, {other}).keys.contains(asked) || idle.contains(other + "." + asked)))
      configuration.refuse(sweep.key,
                           fmt::format("has no effect: engine = \"{}\" does not use [{}], engine = \"{}\" does",
                                       engine, other, other),
                           "choose that engine, or sweep another key");
  refuse_idle("coupling");
}

[[noreturn]] void refuse_key(const Configuration& configuration, const Sweep& sweep, const std::string& asked,
                             const std::vector<SweepTable>& tables, bool of_grains) {
  std::vector<std::string> names;
  for (const SweepTable& table : tables) names.insert(names.end(), table.keys.begin(), table.keys.end());
  std::string meant = did_you_mean(asked, names, "");
  for (const std::string& key : keys_of_symbol(asked))  // such as "k"
    if (std::ranges::find(names, key) != names.end()) meant = fmt::format("did you mean \"{}\"?", key);
  if (asked == "scheme") meant = "give several schemes by study.scheme;";
  if (!meant.empty()) meant += " ";
  configuration.refuse(sweep.key, "cannot be swept",
                       fmt::format("{}allowed: {}a key with one value of {}", meant, of_grains ? "sample, or " : "",
                                   list_of_keys(tables)));
}

}  // namespace

void find_swept_key(const Configuration& configuration, const std::string& engine, const std::string& sample,
                    Sweep& sweep) {
  const std::vector<SweepTable> tables = sweep_tables(configuration, engine, sample);
  const std::string written = sweep.key.substr(sweep.key.find('.') + 1);
  const bool of_grains = !is_closed_form(engine);
  if (written == "sample" && of_grains) {
    sweep.name = written;
    return;
  }
  const std::size_t dot = written.find('.');
  const std::string table_asked = dot == std::string::npos ? "" : written.substr(0, dot);
  const std::string asked = dot == std::string::npos ? written : written.substr(dot + 1);
  std::vector<std::string> having;
  for (const SweepTable& table : tables)
    if (table.keys.contains(asked) && (table_asked.empty() || table_asked == table.name)) having.push_back(table.name);
  if (having.empty()) refuse_key_without_effect(configuration, sweep, table_asked, asked, engine);
  if (having.empty()) refuse_key(configuration, sweep, asked, tables, of_grains);
  if (having.size() > 1)
    configuration.refuse(sweep.key, fmt::format("may mean a key of [{}]", fmt::join(having, "] or [")),
                         fmt::format("write sweep.{}.{} or sweep.{}.{}", having[0], asked, having[1], asked));
  sweep.table = having.front();
  sweep.name = asked;
}

}  // namespace flowslide
