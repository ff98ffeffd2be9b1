// SPDX-License-Identifier: GPL-2.0-or-later
#include "study_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "program/runout.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"
#include "run/legend.hpp"

namespace flowslide {
namespace {

/// A text for gnuplot, where "_" would begin an index.
std::string plain(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += c == '_' ? "\\_" : std::string(1, c);
  return escaped;
}

std::string unit_of_values(const Sweep& sweep) { return sweep.unit.empty() ? "1" : sweep.unit; }

std::string runs_table(const StudyFigure& study, const Ensembles& slides) {
  std::string text = table_head({{"slide", "", "text", "name of the run", "", {}},
                                 {"scheme", "", "text", "its scheme", "", {}},
                                 {"value", "", unit_of_values(study.sweep), "value of the swept key", "", {}},
                                 {"samples", "n", "1", "number of samples", "", {}}});
  for (const StudyRun& run : study.runs) {
    const auto found = slides.find(run.name);
    if (found == slides.end()) continue;
    text += fmt::format("{} {} {} {}\n", run.name, run.scheme, shortest(run.value.as_written), found->second.size());
  }
  return text;
}

Series sweep_table(const StudyFigure& study, const Ensembles& slides) {
  std::vector<std::pair<std::string, std::vector<SweepMember>>> schemes;
  for (const std::string& scheme : study.schemes) {
    schemes.push_back({scheme, {}});
    if (!study.sweep.exists()) continue;
    for (const StudyRun& run : study.runs)
      if (const auto found = slides.find(run.name); run.scheme == scheme && found != slides.end())
        schemes.back().second.push_back({run.value.number, &found->second});
  }
  const Column axis{"swept", "", study.sweep.exists() ? study.sweep.si_unit : "1",
                    study.sweep.exists() ? study.sweep.key : "no sweep", "", {}};
  Series series = sweep_series(axis, schemes, {"largest_velocity", "peak_shear_stress", "runout", "sliding_stopped"});
  Column as_written{"as_written", "", unit_of_values(study.sweep), "the same in the unit of the study", "", {}};
  for (const double number : series.axis.values)
    as_written.values.push_back(std::ranges::find(study.sweep.values, number, &SweepValue::number)->as_written);
  series.columns.insert(series.columns.begin(), as_written);
  return series;
}

std::string note_of(const StudyFigure& study, const Ensembles& slides) {
  if (slides.empty()) return "no run is complete";
  std::size_t fewest = slides.begin()->second.size(), most = fewest;
  for (const auto& [name, ensemble] : slides) {
    fewest = std::min(fewest, ensemble.size());
    most = std::max(most, ensemble.size());
  }
  const std::string samples = fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
  return fmt::format("{}; {} sample{} per run; scale {}", study.engine, samples, most == 1 ? "" : "s",
                     slides.begin()->second.front().provenance.scale);
}

/// Whether two runs have the same rows, bit by bit.
bool have_same_rows(const Result& one, const Result& other) {
  const auto same = [](const Column& a, const Column& b) {
    return std::ranges::equal(a.values, b.values,
                              [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); });
  };
  return same(one.series.axis, other.series.axis) && std::ranges::equal(one.series.columns, other.series.columns, same);
}

}  // namespace

bool is_sweep_without_effect(const StudyFigure& study, const std::string& scheme, const Ensembles& slides) {
  const Ensemble* first = nullptr;
  int values = 0;
  for (const StudyRun& run : study.runs) {
    const auto found = slides.find(run.name);
    if (run.scheme != scheme || found == slides.end()) continue;
    ++values;
    if (first == nullptr) first = &found->second;
    if (!std::ranges::equal(*first, found->second, have_same_rows)) return false;
  }
  return values > 1;
}

void write_study_tables(const OutputFolder& output, const StudyFigure& study, const Ensembles& slides) {
  write_atomically(output.file("slides.dat"), runs_table(study, slides));
  write_table(output.file("sweep.dat"), {{{"case", study.case_name}}, sweep_table(study, slides)});
  Legend legend;
  for (const StudyRun& run : study.runs)
    if (slides.contains(run.name)) legend.add(run.name, plain(study.sweep.exists() ? run.value.text : run.scheme));
  if (study.sweep.exists()) legend.add("x axis", plain(study.sweep.axis_label()));
  if (!study.sweep.is_of_numbers) legend.add("x texts", "yes");
  legend.add("note", plain(note_of(study, slides)));
  legend.write(output);
}

}  // namespace flowslide
