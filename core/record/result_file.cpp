// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/result_file.hpp"

#include <fmt/format.h>

#include "record/sealed_file.hpp"
#include "record/series_group.hpp"

namespace flowslide {
namespace {

constexpr const char* result_remedy = "delete it and execute that run again";

/// Calls `visit(name, member)` for each member. Writing and reading share this list.
template <typename P, typename Visit>
void for_each_member(P& provenance, Visit&& visit) {
  visit("code_version", provenance.code_version);
  visit("git_revision", provenance.git_revision);
  visit("git_state", provenance.git_state);
  visit("compiler", provenance.compiler);
  visit("compiler_flags", provenance.compiler_flags);
  visit("build_type", provenance.build_type);
  visit("paper_doi", provenance.paper_doi);
  visit("host", provenance.host);
  visit("command_line", provenance.command_line);
  visit("start_time", provenance.start_time);
  visit("engine", provenance.engine);
  visit("engine_version", provenance.engine_version);
  visit("mpi_ranks", provenance.mpi_ranks);
  visit("case", provenance.case_name);
  visit("point", provenance.point);
  visit("figure", provenance.figure);
  visit("scale", provenance.scale);
  visit("seed", provenance.seed);
  visit("replicate", provenance.replicate);
  visit("sample", provenance.sample);
  visit("predicted_seconds", provenance.predicted_seconds);
  visit("processor_seconds", provenance.processor_seconds);
}

struct ReadMember {
  const hdf5::Group& root;
  void operator()(const char* name, std::string& value) const { value = root.text_attribute(name); }
  void operator()(const char* name, std::int64_t& value) const { value = root.integer_attribute(name); }
  void operator()(const char* name, int& value) const { value = static_cast<int>(root.integer_attribute(name)); }
  /// The costs; files of version 0.1 and before do not have them.
  void operator()(const char* name, double& value) const {
    if (root.has_attribute(name)) value = root.number_attribute(name);
  }
};

hdf5::File open_result(const std::filesystem::path& path) {
  return hdf5::File::open(read_sealed(path, result_remedy), path.string());
}

}  // namespace

void write_result(const std::filesystem::path& path, const Result& result, IfExists if_exists) {
  auto file = hdf5::File::create(path.string());
  write_result(file.root(), result);
  write_sealed(path, file.image(), if_exists);
}

void write_result(hdf5::Group& root, const Result& result) {
  for_each_member(result.provenance, [&](const char* name, const auto& value) { root.set_attribute(name, value); });
  root.set_attribute("configuration_hash", result.configuration_hash);
  root.write_text("configuration", result.configuration).set_attribute("hash", result.configuration_hash);
  write_series(root, "series", result.series);
  write_metrics(root, "metrics", result.metrics);
  root.write_text("identity", result.identity);
  auto inputs = root.create_group("inputs");
  for (const InputTable& table : result.inputs) {
    write_series(inputs, table.name, table.rows);
    auto group = inputs.group(table.name);
    group.set_attribute("file", table.file);
  }
  write_metrics(root, "parameters", result.parameters);
  auto windows = root.create_group("windows");
  for (const Series& series : result.windows) write_series(windows, series.axis.name, series);
}

Result read_result(const std::filesystem::path& path) {
  return read_result(open_result(path).root());
}

Result read_result(const hdf5::Group& root) {
  Result result;
  for_each_member(result.provenance, ReadMember{root});
  result.configuration_hash = root.text_attribute("configuration_hash");
  result.configuration = root.read_text("configuration");
  result.series = read_series(root, "series");
  result.metrics = read_metrics(root, "metrics");
  if (!root.has("identity")) return result;  // a file of version 0.1 or before
  result.identity = root.read_text("identity");
  const auto inputs = root.group("inputs");
  for (const std::string& name : inputs.names())
    result.inputs.push_back({name, inputs.group(name).text_attribute("file"), read_series(inputs, name)});
  result.parameters = read_metrics(root, "parameters");
  const auto windows = root.group("windows");
  for (const std::string& abscissa : windows.names()) result.windows.push_back(read_series(windows, abscissa));
  return result;
}

}  // namespace flowslide
