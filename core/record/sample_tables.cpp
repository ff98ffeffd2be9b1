// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "grains/contact_network.hpp"
#include "grains/radial_distribution.hpp"
#include "grains/void_ratio_profile.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

constexpr double bin_width = 0.05, longest_distance = 3.0;  // mean diameters

Series slices(const Assembly& sample, int axis) {
  const std::vector<double> void_ratios = void_ratio_profile(sample, axis, slices_of_a_diameter(sample, axis));
  const auto count = static_cast<double>(void_ratios.size());
  const std::vector<double> away = without_wall_layers(void_ratios);
  const double inner = std::accumulate(away.begin(), away.end(), 0.0) / static_cast<double>(away.size());
  const double band =
      2.0 * counting_deviation(sample.cell.volume() / sample.cell.lengths()[axis], sample.mean_diameter());
  Series series{{"place", "x / L", "1", "place across the cell", "", {}},
                {{"void_ratio", "e", "1", "void ratio of the slice", ""},
                 {"lowest_random", "e", "1", "mean less two deviations of counting", ""},
                 {"highest_random", "e", "1", "mean and two deviations of counting", ""}}};
  for (std::size_t i = 0; i < void_ratios.size(); ++i)
    series.append_row((static_cast<double>(i) + 0.5) / count, std::array{void_ratios[i], inner - band, inner + band});
  return series;
}

Series distances(const Assembly& sample) {
  double reach = longest_distance;
  for (int axis = 0; axis < 3; ++axis)
    if (sample.cell.periodic[axis]) reach = std::min(reach, 0.5 * sample.cell.lengths()[axis] / sample.mean_diameter());
  const int bins = std::max(1, static_cast<int>(std::floor(reach / bin_width)));
  const RadialDistribution found = radial_distribution(sample, bins * bin_width, bins);
  Series series{{"distance", "r / D", "1", "distance of two centres in mean diameters", "", {}},
                {{"density", "g", "1", "radial distribution function", ""}}};
  for (std::size_t i = 0; i < found.distance.size(); ++i)
    series.append_row(found.distance[i], std::array{found.density[i]});
  return series;
}

Series contacts(const Assembly& sample) {
  Series series{{"contacts", "Z", "1", "contacts of a mobile grain", "", {}},
                {{"share", "", "1", "share of the mobile grains", ""}}};
  const std::vector<double> shares = contact_network(sample).shares;
  for (std::size_t number = 0; number < shares.size(); ++number)
    series.append_row(static_cast<double>(number), std::array{shares[number]});
  return series;
}

}  // namespace

void write_sample_tables(const std::filesystem::path& folder, const std::string& name, const Assembly& sample) {
  const auto write = [&](const std::string& what, Series series) {
    write_table(folder / (name + "_" + what + ".dat"), {{{"sample", name}}, std::move(series)});
  };
  for (int axis = 0; axis < 3; ++axis) write(std::string("slices_") + "xyz"[axis], slices(sample, axis));
  write("distances", distances(sample));
  write("contacts", contacts(sample));
}

}  // namespace flowslide
