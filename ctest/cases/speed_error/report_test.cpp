// SPDX-License-Identifier: GPL-2.0-or-later
#include "report.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "record/hdf5.hpp"
#include "record/sealed_file.hpp"
#include "record/series_group.hpp"
#include "record/temporary_folder.hpp"
#include "runs.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class ReportTest : public testing::Test {
 protected:
  static Report report() {
    static const std::vector<Axis> axes{
        {"pulse_dt_L", "dt_L", Scene::pulse, "pulse_fine", {"pulse", "pulse_coarse"}, true}};
    const Ensembles runs{{"pulse_fine", pulses({1.0, 2.0, 3.0}, 100.0)},
                         {"pulse", pulses({1.1, 2.1, 3.1}, 10.0)},
                         {"pulse_coarse", pulses({4.0, 5.0, 6.0}, 5.0)}};
    Report made{errors_of(axes, runs), {}, {{Scene::pulse, {2000.0, 1e6, 1e-6}}}};
    for (const Scene scene : all_scenes) made.candidates[scene] = candidates_of(made.errors, scene);
    return made;
  }
};

TEST_F(ReportTest, TellsErrorCostAndSpeedUp) {
  const std::string text = markdown(report());
  EXPECT_CONTAINS(text, "| base | dt_L | fine | 1000 | 1e+05 | 10 | 1e+04 | 5 ± 0 (100) | 0 ± 0 (9.5) | 0.05 | below "
                        "the noise | 200 | 100 |");
  EXPECT_CONTAINS(text, "| coarse | dt_L | fine | 1000 | 1e+05 | 5 | 2e+04 | 150 ± 0 (100) | 0 ± 0 (9.5) | 1.5 | "
                        "**v_max** | 400 | 200 |");
  EXPECT_CONTAINS(text, "- pulse: `pulse`, 1000 grains, 10 s, error 0.05 of the spread over seeds; 200 times as fast "
                        "as LIGGGHTS at the paper's settings, 100 times with as many grains.");
  EXPECT_CONTAINS(text, "- trigger: no setting has an error below the noise.");
  EXPECT_CONTAINS(text, "- pulse: 2000 spheres x 1e+06 steps x 1e+03 ns = 0.56 h");
}

TEST_F(ReportTest, GivesNoVerdictOnOneSeed) {
  const std::vector<Axis> axes{{"pulse_engine", "engine", Scene::pulse, "pulse", {"pulse_liggghts"}, true}};
  const Ensembles runs{{"pulse", pulses({1.0, 2.0})}, {"pulse_liggghts", pulses({1.1})}};
  const Report one{errors_of(axes, runs), {{Scene::element, {}}, {Scene::trigger, {}}, {Scene::pulse, {}}}, {}};
  EXPECT_CONTAINS(markdown(one), " | inf | one seed | - | - |");
}

TEST_F(ReportTest, GivesGnuplotAndHdf5WhatTheTableHas) {
  const TemporaryFolder folder;
  write_report(folder.path(), report());
  const auto text = [&](const char* name) {
    std::ifstream file(folder.path() / name);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  };
  EXPECT_CONTAINS(text("errors_pulse.dat"), "\nbase dt_L 10 100000000 0.05");
  EXPECT_CONTAINS(text("pulse_front.dat"), "\ncoarse 5 1.5\nbase 10 0.05");
  EXPECT_CONTAINS(text("paper.dat"), "\npulse 2000\n");
  for (const char* name : {"errors_pulse.dat", "errors_element.dat"})
    EXPECT_TRUE(text(name).starts_with("label axis seconds grain_steps error_over_spread below_noise\n# ")) << name;
  EXPECT_EQ(text("table.md"), markdown(report()));

  const auto file = hdf5::File::open(read_sealed(folder.path() / "table.h5", ""), "table.h5");
  const Series series = read_series(file.root().group("pulse"), "table");
  EXPECT_EQ(series.column("processor_seconds").values, (std::vector{5.0, 10.0}));
  EXPECT_EQ(series.column("below_noise").values, (std::vector{0.0, 1.0}));
  EXPECT_DOUBLE_EQ(series.column("largest_velocity_spread").values[0], 1.0);
  EXPECT_EQ(file.root().group("pulse").read_text("settings"), "pulse_coarse\npulse\n");
  EXPECT_EQ(file.root().group("pulse").number_attribute("paper_seconds"), 2000.0);
  EXPECT_EQ(read_series(file.root().group("element"), "table").rows(), 0U);
}

TEST_F(ReportTest, NamesSettingsWithoutTheirScene) {
  EXPECT_EQ(label_of("pulse", Scene::pulse), "base");
  EXPECT_EQ(label_of("pulse_dt_5e-6", Scene::pulse), "dt_5e-6");
  EXPECT_EQ(label_of("other", Scene::pulse), "other");
}

}  // namespace
}  // namespace flowslide
