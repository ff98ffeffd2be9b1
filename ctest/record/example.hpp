// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "grains/assembly.hpp"
#include "record/result_file.hpp"

namespace flowslide {

/// Values that a careless text form would change, and ordinary ones.
inline Series example_series(std::size_t rows = 50) {
  Series series;
  series.columns = {{"shear_stress", "tau", "Pa", "shear stress", "positive downslope", {}},
                    {"normal_stress", "sigma", "Pa", "normal stress", "compression positive", {}},
                    {"inertial_number", "I", "1", "inertial number", "", {}}};
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (std::size_t i = 0; i < rows; ++i)
    series.append_row(0.1 * static_cast<double>(i),
                      std::vector{1e4 * uniform(random), std::exp(600.0 * uniform(random)), uniform(random) / 3.0});
  const std::vector<double> hard{-0.0, 5e-324, 1.7976931348623157e308, 0.1 + 0.2};
  for (std::size_t i = 0; i < std::min(rows, hard.size()); ++i) series.columns[0].values[i] = hard[i];
  return series;
}

inline Result example_result() {
  Result result;
  result.provenance = start_provenance({});
  result.provenance.case_name = "fig03_undrained";
  result.provenance.point = "e0=0.790";
  result.provenance.figure = "3";
  result.provenance.scale = "quick";
  result.provenance.engine = "liggghts";
  result.provenance.engine_version = "3.8.0";
  result.provenance.command_line = "fig03_undrained --set 'angle=5°'";
  result.provenance.seed = -9007199254740993;
  result.provenance.mpi_ranks = 2;
  result.provenance.replicate = 3;
  result.provenance.predicted_seconds = 60.0;
  result.provenance.processor_seconds = 75.0;
  result.configuration = "[sample]\nseed = 7\n";
  result.configuration_hash = "abc123";
  result.series = example_series();
  result.metrics = {{"peak_shear_stress", 1234.5, "Pa", "peak of the shear stress"},
                    {"strain_at_peak", 0.015, "1", "shear strain at the peak"}};
  result.identity = "point name = e0=0.790\n";
  InputTable loading{"loading", "quake.txt", {}};
  loading.rows.axis.values = {0.0, 1.0};
  loading.rows.columns = {
      {"stress_change", "Delta tau_d", "Pa", "change of the driving shear stress", "", {0.0, 500.0}}};
  result.inputs = {loading};
  result.parameters = {{"hydraulic_conductivity", 2e-5, "m/s", "hydraulic conductivity"}};
  for (const char* abscissa : {"time", "displacement"}) {
    result.windows.push_back(example_series(7));
    result.windows.back().axis.name = abscissa;
  }
  result.provenance.sample = "loose 3f2a";
  return result;
}

/// Not a possible packing: every number is different, so that a mix-up shows.
inline Assembly example_assembly(std::size_t n = 40) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const auto vector = [&] { return Vector3(uniform(random), uniform(random), uniform(random)); };
  Assembly assembly;
  assembly.resize(n);
  assembly.cell = {Vector3(-0.1, -0.2, 0.0), Vector3(0.3, 0.2, 0.5), {true, true, false}};
  for (std::size_t i = 0; i < n; ++i) {
    assembly.radius[i] = 0.003 + 0.001 * uniform(random);
    assembly.position[i] = vector();
    assembly.velocity[i] = vector();
    assembly.spin[i] = vector();
    assembly.force[i] = vector();
    assembly.torque[i] = vector();
    assembly.role[i] = static_cast<Role>(i % 3);
  }
  for (std::uint32_t i = 0; i + 2 < n; ++i)
    for (std::uint32_t j : {i + 1, i + 2}) assembly.contacts.push_back({i, j, vector(), vector()});
  return assembly;
}

}  // namespace flowslide
