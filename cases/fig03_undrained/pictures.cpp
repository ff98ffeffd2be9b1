// SPDX-License-Identifier: GPL-2.0-or-later
#include "pictures.hpp"

#include <fmt/format.h>

#include "record/sample_picture.hpp"
#include "record/sample_tables.hpp"
#include "record/snapshot.hpp"

namespace flowslide {
namespace {
constexpr int frames_before_last = 5;
}

std::vector<double> frame_strains(double strain) {
  std::vector<double> strains;
  for (int frame = 0; frame <= frames_before_last; ++frame)
    strains.push_back(strain * static_cast<double>(frame) / frames_before_last);
  return strains;
}

void write_frames(const OutputFolder& output, const std::string& name, const std::vector<Shot>& shots) {
  View view;
  write_picture(output.file("fig02_before.dat"), shots.front().assembly, view);
  write_sample_tables(output.path(), "fig02", shots.front().assembly);
  view.shear_strain = shots.back().strain;
  write_picture(output.file("fig02_during.dat"), shots.back().assembly, view);
  std::filesystem::create_directories(output.file(name + "_frames"));
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < shots.size(); ++i) {
    const std::string grains = fmt::format("{}_frames/grains_{}.vtp", name, i);
    const std::string cell = fmt::format("{}_frames/cell_{}.vtp", name, i);
    write_grains(output.file(grains), shots[i].assembly);
    write_cell(output.file(cell), shots[i].assembly.cell);
    frames.push_back({shots[i].time, grains, 0});
    frames.push_back({shots[i].time, cell, 1});
  }
  write_collection(output.file(name + ".pvd"), frames);
}

}  // namespace flowslide
