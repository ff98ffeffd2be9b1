// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/layers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "configuration/entry_reader.hpp"
#include "configuration/error.hpp"
#include "configuration/nearest.hpp"

namespace flowslide {
namespace {

/// Removes the key `base` from the entries of a file. Returns the path that it gives, relative to the folder of that
/// file; an empty path if there is no such key.
std::filesystem::path take_base(std::vector<Entry>& file) {
  const auto named = std::find_if(file.begin(), file.end(), [](const Entry& entry) { return entry.key == "base"; });
  if (named == file.end()) return {};
  const auto* name = std::get_if<std::string>(&named->whole.value);
  if (named->kind != Entry::Kind::value || name == nullptr)
    throw ConfigurationError(fmt::format("{}: base is not a text; name a file, such as base = \"../paper.toml\"",
                                         named->key_place.text()));
  const std::filesystem::path base = std::filesystem::path(named->whole.place.origin).parent_path() / *name;
  file.erase(named);
  return base.lexically_normal();
}

/// `reason` is a clause that says why a file of this kind has no base.
void refuse_base(const std::vector<Entry>& file, std::string_view reason) {
  for (const Entry& entry : file)
    if (entry.key == "base")
      throw ConfigurationError(fmt::format("{}: {}; take the key out", entry.key_place.text(), reason));
}

/// Names of the scales of a file, in the order of the file. Throws ConfigurationError if [scale] holds a value.
std::vector<std::string> scales_of(const std::vector<Entry>& file) {
  std::vector<std::string> scales;
  for (const Entry& entry : file) {
    if (entry.key == "scale" && entry.kind != Entry::Kind::table)
      throw ConfigurationError(
          fmt::format("{}: scale = {} is a value, but [scale] holds one table per scale; choose the "
                      "scale with --scale",
                      entry.key_place.text(), entry.whole.written));
    if (!stands_below(entry.key, "scale") || entry.key.find('.', 6) != std::string::npos) continue;
    const std::string name = entry.key.substr(6);
    if (entry.kind != Entry::Kind::table)
      throw ConfigurationError(fmt::format("{}: scale.{} is a value, but [scale] holds one table per scale only",
                                           entry.key_place.text(), name));
    scales.push_back(name);
  }
  return scales;
}

/// Lays a file over `laid.all`: first the keys outside [scale], then those of the chosen scale. The keys of the other
/// scales go to `laid.unselected`.
void lay_over(LaidEntries& laid, std::vector<Entry> file, const std::string& scale) {
  const std::vector<std::string> scales = scales_of(file);
  std::vector<Entry> all_scales = take_below(file, "scale");
  overlay(laid.all, file);
  for (const std::string& name : scales) {
    const std::vector<Entry> members = take_below(all_scales, name);
    if (name == scale)
      overlay(laid.all, members);
    else
      laid.unselected.insert(laid.unselected.end(), members.begin(), members.end());
  }
}

/// Lays the case file over its base. Returns the names of the scales of both.
std::vector<std::string> lay_published(LaidEntries& laid, const Layers& layers) {
  std::vector<Entry> case_file = read_entries(layers.case_file), base_file;
  if (const std::filesystem::path base = take_base(case_file); !base.empty()) {
    base_file = read_entries(base);
    refuse_base(base_file, "the base of a case.toml has no base of its own");
    laid.base = base.string();
  }
  std::vector<std::string> scales = scales_of(base_file);
  for (const std::string& scale : scales_of(case_file))
    if (std::find(scales.begin(), scales.end(), scale) == scales.end()) scales.push_back(scale);
  if (!layers.scale.empty() && std::find(scales.begin(), scales.end(), layers.scale) == scales.end()) {
    throw ConfigurationError(
        fmt::format("{}: there is no scale \"{}\" (there is {}); add a table [scale.{}] or choose "
                    "another --scale",
                    layers.case_file.string(), layers.scale, list_of(scales), layers.scale));
  }
  lay_over(laid, std::move(base_file), layers.scale);
  lay_over(laid, std::move(case_file), layers.scale);
  laid.published = laid.all;
  return scales;
}

void lay_user_file(LaidEntries& laid, const Layers& layers, const std::vector<std::string>& scales) {
  std::vector<Entry> file = read_entries(*layers.user_file);
  refuse_base(file, "a file for --config is laid over the case.toml of the case and has no base");
  for (const std::string& name : scales_of(file)) {
    if (std::find(scales.begin(), scales.end(), name) != scales.end()) continue;
    const auto table =
        std::find_if(file.begin(), file.end(), [&](const Entry& entry) { return entry.key == "scale." + name; });
    throw ConfigurationError(fmt::format("{}: there is no scale \"{}\" in {}; there is {}", table->key_place.text(),
                                         name, layers.case_file.string(), list_of(scales)));
  }
  lay_over(laid, std::move(file), layers.scale);
}

}  // namespace

LaidEntries lay(const Layers& layers) {
  LaidEntries laid;
  const std::vector<std::string> scales = lay_published(laid, layers);
  if (layers.user_file) lay_user_file(laid, layers, scales);
  for (const Override& item : layers.overrides) overlay(laid.all, read_option(item.key, item.value, item.option));
  return laid;
}

}  // namespace flowslide
