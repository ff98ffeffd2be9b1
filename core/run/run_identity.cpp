// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/run_identity.hpp"

#include <fmt/format.h>

#include <utility>

#include "dem/make_engine.hpp"
#include "record/hash.hpp"
#include "run/difference.hpp"
#include "sample/closed_form.hpp"
#include "sample/preparation.hpp"
#include "sample/void_ratio_search.hpp"

namespace flowslide {
namespace {

constexpr const char* first_line = "case name = ";

}  // namespace

std::string engine_version(const std::string& name) {
  return is_closed_form(name) ? closed_form_version(name) : make_engine(name, "/dev/null")->version();
}

std::string preparation_identity(const std::string& engine, const std::string& version) {
  return fmt::format("{} {}, procedure {}", engine, version, preparation_version());
}

RunIdentity::RunIdentity(const std::string& case_name, const std::string& point, RunInputs inputs,
                         std::string configuration)
    : inputs_(std::move(inputs)), configuration_(std::move(configuration)) {
  const auto add = [&](const std::string& name, const std::string& value) { beyond_ += name + " = " + value + "\n"; };
  beyond_ = first_line + case_name + "\n";
  add("point name", point);
  if (!inputs_.engine.empty()) add("engine version", inputs_.engine + " " + engine_version(inputs_.engine));
  if (const std::string& name = inputs_.preparation_engine; !name.empty()) {
    add("preparation version", preparation_identity(name, engine_version(name)));
    add("sample search version", search_version());
  }
  for (const InputTable& table : inputs_.tables) add(table.name + " table", content_of(table));
}

RunIdentity::RunIdentity(const Result& made) : beyond_(made.identity), configuration_(made.configuration) {
  inputs_.tables = made.inputs;
}

RunIdentity RunIdentity::from_text(const std::string& text) {
  RunIdentity identity;
  identity.configuration_ = text;
  return identity;
}

std::string RunIdentity::difference_from(const RunIdentity& there) const {
  if (*this == there) return "";
  if (!there.text().starts_with(first_line))
    return "it is of a version that recorded neither its engine nor its tables";
  const std::string difference = difference_of(there.text(), text());
  return difference.empty() ? "the form of the configuration" : difference;
}

void RunIdentity::stamp(Result& result) const {
  result.configuration = configuration_;
  result.configuration_hash = hash_of(configuration_);
  result.identity = beyond_;
  result.inputs = inputs_.tables;
}

FoundResult find_result(const std::filesystem::path& file, const RunIdentity& identity) {
  if (!std::filesystem::exists(file)) return {};
  try {
    const std::string difference = identity.difference_from(RunIdentity(read_result(file)));
    return {difference.empty() ? Standing::complete : Standing::other, difference};
  } catch (const FileError& error) {
    return {Standing::damaged, error.what()};
  }
}

}  // namespace flowslide
