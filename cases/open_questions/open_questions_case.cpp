// SPDX-License-Identifier: GPL-2.0-or-later
#include "open_questions_case.hpp"

#include <array>
#include <cmath>

#include "answers.hpp"
#include "point_metrics.hpp"
#include "program/runout.hpp"
#include "record/atomic_file.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr int law_rows = 60;  ///< rows of a law in its table, evenly spaced in log I
constexpr double smallest_number = 1e-4, largest_number = 3.0;

Column friction_column(const std::string& name, const std::string& text) { return {name, "mu", "1", text, "", {}}; }

/// The law of glass beads and the law that fits the states. Without rows if the states do not determine a law.
Series laws_series(const std::vector<SteadyState>& states) {
  Series laws;
  laws.axis = {"inertial_number", "I", "1", "inertial number", "", {}};
  laws.columns = {friction_column("fitted", "friction by the fitted law"),
                  friction_column("glass_beads", "friction by the law of Jop et al. (2006) for glass beads")};
  if (!tell_a_law(states)) return laws;
  const FrictionLaw fitted = fit_friction_law(states);
  for (int k = 0; k <= law_rows; ++k) {
    const double number =
        smallest_number * std::pow(largest_number / smallest_number, static_cast<double>(k) / law_rows);
    laws.append_row(number, std::array{fitted.at(number), law_of_glass_beads().at(number)});
  }
  return laws;
}

/// The steady states of the runs whose name begins with `start`, one row each.
Series states_series(const Ensembles& slides, const std::string& start) {
  Series states;
  states.axis = {"inertial_number", "I", "1", "inertial number", "", {}};
  states.columns = {friction_column("friction", "friction of steady shear"),
                    {"shear_rate", "gamma_dot", "1/s", "shear rate", "", {}},
                    {"void_ratio", "e", "1", "void ratio, which a constant volume keeps", "", {}}};
  for (const auto& [name, ensemble] : slides) {
    if (!name.starts_with(start)) continue;
    for (const Result& result : ensemble) {
      const double number = metric_of(result, "inertial_number"), friction = metric_of(result, "friction");
      const double rate = metric_of(result, "shear_rate"), void_ratio = metric_of(result, "initial_void_ratio");
      if (std::isfinite(number + friction + rate + void_ratio))
        states.append_row(number, std::array{friction, rate, void_ratio});
    }
  }
  return states;
}

}  // namespace

std::unique_ptr<Case> make_case() { return std::make_unique<OpenQuestionsCase>(); }

OpenQuestionsCase::OpenQuestionsCase()
    : SlideCase({"open_questions",
                 "What the paper left open: homogeneous shear, size, mu(I), natural frequencies",
                 FLOWSLIDE_VERSION,
                 {"open_questions"},
                 {}}) {}

std::vector<Metric> OpenQuestionsCase::slide_metrics(const SlideOutcome& outcome) const {
  std::vector<Metric> metrics;
  const SlidePoint& point = outcome.point;
  const Material& material = point.sample.recipe.material;
  if (outcome.grains)
    metrics.push_back({"grains", static_cast<double>(outcome.grains->size()), "1", "number of grains"});
  const auto add = [&](const std::vector<Metric>& more) { metrics.insert(metrics.end(), more.begin(), more.end()); };
  if (!point.test) {
    add(std::holds_alternative<SinePulse>(point.settings.loading)
            ? pulse_runout(outcome)
            : held_metrics(outcome.measures, outcome.profiles, outcome.series.last("velocity")));
    return metrics;
  }
  const Assembly grains = outcome.grains->assembly();
  if (point.test->final_strain > probe_strain) {
    add(flow_metrics(outcome.series, point.test->shear_rate, grains.mean_diameter(), material.density));
    return metrics;
  }
  const double density = material.density * grains.solid_volume() / grains.cell.volume();
  add(probe_metrics(outcome.series, {grains.cell.height(), density, grains.cell.periodic[2]}, slope()));
  return metrics;
}

void OpenQuestionsCase::compare(const Ensembles& slides, std::map<std::string, double>& metrics) const {
  add_answers(slides, metrics);
}

std::vector<std::string> OpenQuestionsCase::tables() const {
  std::vector<std::string> tables = SlideCase::tables();
  tables.insert(tables.end(), {"sizes_glued", "sizes_homogeneous", "mu_of_I_loose", "mu_of_I_middle", "mu_of_I_dense",
                               "mu_of_I_laws"});
  return tables;
}

void OpenQuestionsCase::finish(const OutputFolder& output) const {
  SlideCase::finish(output);
  const Ensembles slides = results_in(output.path(), points_in(output));
  for (const std::string sample : {"glued", "homogeneous"})
    write_table(output.file("sizes_" + sample + ".dat"), {{}, sizes_series(slides, "pulse_" + sample)});
  for (const char* kind : {"loose", "middle", "dense"})
    write_table(output.file(std::string("mu_of_I_") + kind + ".dat"),
                {{}, states_series(slides, std::string("flow_") + kind)});
  write_table(output.file("mu_of_I_laws.dat"), {{}, laws_series(steady_states(slides))});
  write_atomically(output.file("table.md"), answers_table(slides));
}

}  // namespace flowslide
