// SPDX-License-Identifier: GPL-2.0-or-later
#include "report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "record/gnuplot_table.hpp"
#include "record/hdf5.hpp"
#include "record/sealed_file.hpp"
#include "record/series_group.hpp"

namespace flowslide {
namespace {

/// Smallest error/spread in a figure. The axis is logarithmic, so this value replaces all smaller ones.
constexpr double least_shown = 1e-4;

std::string title_of(Scene scene) {
  if (scene == Scene::element) return "Element test: peak tau, strain at peak, strain at liquefaction";
  if (scene == Scene::trigger) return "Trigger: time of instability, v at 50 % strain";
  return "Pulse: largest v, runout";
}

std::string symbol_of(const std::string& quantity) {
  static const std::map<std::string, std::string> symbols{
      {"peak_shear_stress", "peak tau"},      {"strain_at_peak", "strain at peak"},
      {"strain_at_liquefaction", "liquefied"}, {"instability_time", "t_instability"},
      {"velocity_at_half", "v at 50 %"},      {"largest_velocity", "v_max"},
      {"runout", "runout"}};
  return symbols.at(quantity);
}

std::string percent(double share) {
  if (!std::isfinite(share)) return "-";
  return share < 1.0 ? fmt::format("{:.2g}", 100.0 * share) : fmt::format("{:.0f}", 100.0 * share);
}

std::string error_text(const QuantityError& error) {
  return fmt::format("{} ± {} ({})", percent(error.error), percent(error.standard_error), percent(error.spread));
}

std::string verdict_of(const SettingError& row) {
  if (row.below_noise()) return "below the noise";
  const bool one_seed = std::ranges::any_of(row.errors, [](const QuantityError& error) {
    return std::isfinite(error.error) && std::isnan(error.standard_error);
  });
  return one_seed ? "one seed" : "**" + symbol_of(row.worst) + "**";
}

std::string times_text(double times) {
  return times < 1e4 ? fmt::format("{:.3g}", times) : fmt::format("{:.2g}", times);
}

const PaperCost* paper_of(const Report& report, Scene scene) {
  const auto found = report.paper.find(scene);
  return found == report.paper.end() ? nullptr : &found->second;
}

/// Two cells: the speed-up against LIGGGHTS at the settings of the paper, with the number of grains of this run, and
/// with that of the paper.
std::string speed_up(const PaperCost* paper, double seconds, double grains) {
  if (paper == nullptr || !(seconds > 0.0)) return "- | -";
  const double times = paper->seconds() / seconds;
  return fmt::format("{} | {}", times_text(times), times_text(times * grains / paper->grains));
}

std::string table_of(const Report& report, Scene scene) {
  const PaperCost* paper = paper_of(report, scene);
  std::string text =
      fmt::format("### {}\n\n| setting | axis | reference | N | steps | core s | steps/s ", title_of(scene));
  std::string rule = "|---|---|---|---|---|---|---";
  for (const std::string& quantity : quantities_of(scene)) {
    text += fmt::format("| {}, % ", symbol_of(quantity));
    rule += "|---";
  }
  text += "| error/spread | verdict | x LIGGGHTS | x, same N |\n" + rule + "|---|---|---|---|\n";
  for (const SettingError& row : report.errors) {
    if (row.axis->scene != scene) continue;
    text += fmt::format("| {} | {} | {} | {:.0f} | {:.3g} | {:.2g} | {:.2g} ", label_of(row.setting, scene),
                        row.axis->title, label_of(row.axis->reference, scene), row.grains, row.steps, row.seconds,
                        row.steps / row.seconds);
    for (const QuantityError& error : row.errors) text += "| " + error_text(error) + " ";
    text += fmt::format("| {:.2g} | {} | {} |\n", row.error_over_spread,
                        verdict_of(row), speed_up(paper, row.seconds, row.grains));
  }
  return text + "\n";
}

std::string recommendation(const Report& report, Scene scene) {
  const Candidate* best = recommended(report.candidates.at(scene));
  if (best == nullptr) return fmt::format("- {}: no setting has an error below the noise.\n", name_of(scene));
  std::string text =
      fmt::format("- {}: `{}`, {} grains, {:.2g} s, error {:.2g} of the spread over seeds", name_of(scene),
                  best->setting, best->grains, best->seconds, best->error_over_spread);
  if (const PaperCost* paper = paper_of(report, scene)) {
    const double times = paper->seconds() / best->seconds;
    text += fmt::format("; {} times as fast as LIGGGHTS at the paper's settings, {} times with as many grains",
                        times_text(times), times_text(times * best->grains / paper->grains));
  }
  return text + ".\n";
}

std::string paper_text(const Report& report, Scene scene) {
  const PaperCost* paper = paper_of(report, scene);
  if (paper == nullptr) return "";
  return fmt::format("- {}: {:.0f} spheres x {:.3g} steps x {:.3g} ns = {:.2g} h\n", name_of(scene), paper->grains,
                     paper->steps, 1e9 * paper->seconds_per_grain_step, paper->seconds() / 3600.0);
}

/// The text as one word of a table: '_' replaces each blank.
std::string word_of(std::string text) {
  std::ranges::replace(text, ' ', '_');
  return text;
}

void write_plot_tables(const std::filesystem::path& folder, const Report& report) {
  const Column label{"label", "", "text", "setting", "", {}};
  const Column seconds{"seconds", "t", "s", "processor time of straining the sample", "", {}};
  const Column error{"error_over_spread", "", "1", "largest error and 2 standard errors over the spread", "", {}};
  for (const Scene scene : all_scenes) {
    std::string all = table_head({label, {"axis", "", "text", "what the setting changes, '_' for each blank", "", {}},
                                  seconds, {"grain_steps", "N n_L", "1", "grains times DEM steps", "", {}}, error,
                                  {"below_noise", "", "1", "1 if every error is at most the spread", "", {}}});
    for (const SettingError& row : report.errors)
      if (row.axis->scene == scene && std::isfinite(row.error_over_spread))
        all += fmt::format("{} {} {} {} {} {}\n", word_of(label_of(row.setting, scene)), word_of(row.axis->title),
                           row.seconds, row.grain_steps, std::max(row.error_over_spread, least_shown),
                           row.below_noise() ? 1 : 0);
    write_atomically(folder / ("errors_" + name_of(scene) + ".dat"), all);
    std::string front = table_head({label, seconds, error});
    for (const Candidate& candidate : report.candidates.at(scene))
      if (candidate.on_front)
        front += fmt::format("{} {} {}\n", word_of(label_of(candidate.setting, scene)), candidate.seconds,
                             std::max(candidate.error_over_spread, least_shown));
    write_atomically(folder / (name_of(scene) + "_front.dat"), front);
  }
  std::string paper = table_head({{"scene", "", "text", "scene", "", {}},
                                  {"seconds", "t", "s", "processor time by LIGGGHTS at the paper's settings", "", {}}});
  for (const auto& [scene, cost] : report.paper) paper += fmt::format("{} {}\n", name_of(scene), cost.seconds());
  write_atomically(folder / "paper.dat", paper);
}

/// Writes the group /<scene>: the table with its columns, and the names of settings, axes and references, one per line.
void write_scene(hdf5::Group& root, const Report& report, Scene scene) {
  Series series;
  series.axis = {"row", "row", "1", "row of the table, by cost", "", {}};
  series.columns = {{"grains", "N", "1", "number of grains", "", {}},
                    {"steps", "n_L", "1", "DEM steps", "", {}},
                    {"grain_steps", "N n_L", "1", "grains times DEM steps", "", {}},
                    {"processor_seconds", "t", "s", "processor time of straining the sample", "", {}},
                    {"below_noise", "", "1", "1 if every error is at most the spread over seeds", "", {}}};
  for (const std::string& quantity : quantities_of(scene))
    for (const char* what : {"error", "standard_error", "spread"})
      series.columns.push_back({quantity + "_" + what, what, "1",
                                fmt::format("{} of the {}, relative; -1 where it is missing", what, quantity), "", {}});
  std::string settings, axes, references;
  for (const SettingError& row : report.errors) {
    if (row.axis->scene != scene) continue;
    std::vector<double> values{row.grains, row.steps, row.grain_steps, row.seconds, row.below_noise() ? 1.0 : 0.0};
    for (const QuantityError& error : row.errors)
      for (const double value : {error.error, error.standard_error, error.spread})
        values.push_back(std::isfinite(value) ? value : -1.0);
    series.append_row(static_cast<double>(series.rows()), values);
    settings += row.setting + "\n";
    axes += row.axis->title + "\n";
    references += row.axis->reference + "\n";
  }
  hdf5::Group group = root.create_group(name_of(scene));
  write_series(group, "table", series);
  group.write_text("settings", settings);
  group.write_text("axes", axes);
  group.write_text("references", references);
  if (const PaperCost* paper = paper_of(report, scene)) group.set_attribute("paper_seconds", paper->seconds());
}

}  // namespace

std::string label_of(const std::string& setting, Scene scene) {
  const std::string name = name_of(scene);
  return setting == name ? "base" : setting.starts_with(name + "_") ? setting.substr(name.size() + 1) : setting;
}

std::string markdown(const Report& report) {
  std::string text =
      "Error against the reference of the axis, in percent: mean of the differences over the seeds ± its standard\n"
      "error, in brackets the spread over the seeds (highest less lowest). error/spread: the mean and two standard\n"
      "errors over the spread. Core seconds: processor time of one process in the sample alone. x LIGGGHTS: as fast\n"
      "as LIGGGHTS at the paper's settings; same N: as fast per grain.\n\n";
  for (const Scene scene : all_scenes) text += table_of(report, scene);
  text += "### The cheapest settings whose error is below the noise\n\n";
  for (const Scene scene : all_scenes) text += recommendation(report, scene);
  text += "\nLIGGGHTS at the paper's settings, extrapolated from its time per grain and step in this table:\n\n";
  for (const Scene scene : all_scenes) text += paper_text(report, scene);
  return text;
}

void write_report(const std::filesystem::path& folder, const Report& report) {
  write_atomically(folder / "table.md", markdown(report));
  write_plot_tables(folder, report);
  auto file = hdf5::File::create((folder / "table.h5").string());
  for (const Scene scene : all_scenes) write_scene(file.root(), report, scene);
  write_sealed(folder / "table.h5", file.image(), IfExists::replace);
}

}  // namespace flowslide
