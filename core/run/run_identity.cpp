// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/run_identity.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "record/hash.hpp"
#include "run/difference.hpp"

namespace flowslide {
namespace {

constexpr const char* first_line = "case name = ";

}  // namespace

RunIdentity::RunIdentity(const std::string& case_name, const std::string& point, RunInputs inputs,
                         std::string configuration, const RunVersions& versions)
    : inputs_(std::move(inputs)), configuration_(std::move(configuration)) {
  const auto add = [&](const std::string& name, const std::string& value) { context_ += name + " = " + value + "\n"; };
  context_ = first_line + case_name + "\n";
  add("point name", point);
  if (inputs_.engine.empty() != versions.engine.empty() ||
      inputs_.preparation_engine.empty() != versions.preparation.empty())
    throw std::invalid_argument("the identity of the run " + point + " needs the version of each of its engines");
  if (!versions.run.empty()) add("run version", versions.run);
  if (!inputs_.engine.empty()) add("engine version", inputs_.engine + " " + versions.engine);
  if (!inputs_.preparation_engine.empty()) {
    add("preparation version", versions.preparation);
    add("sample search version", versions.search);
  }
  for (const InputTable& table : inputs_.tables) add(table.name + " table", content_of(table));
}

RunIdentity::RunIdentity(const Result& made) : context_(made.identity), configuration_(made.configuration) {
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
  return difference.empty() ? "the format of the configuration" : difference;
}

void RunIdentity::stamp(Result& result) const {
  result.configuration = configuration_;
  result.configuration_hash = hash_of(configuration_);
  result.identity = context_;
  result.inputs = inputs_.tables;
}

FoundResult find_result(const std::filesystem::path& file, const RunIdentity& identity) {
  if (!std::filesystem::exists(file)) return {};
  try {
    const std::string difference = identity.difference_from(RunIdentity(read_result(file)));
    return {difference.empty() ? Standing::complete : Standing::other, difference};
  } catch (const CorruptFileError& error) {  // a file that cannot be read now may be sound
    return {Standing::damaged, error.what()};
  }
}

}  // namespace flowslide
