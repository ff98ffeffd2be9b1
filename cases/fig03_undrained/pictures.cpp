// SPDX-License-Identifier: GPL-2.0-or-later
#include "pictures.hpp"

#include <fmt/format.h>

#include "record/sample_picture.hpp"
#include "record/sample_tables.hpp"
#include "record/snapshot.hpp"

namespace flowslide {
namespace {
constexpr int frames_before_picture = 5;
}

void Pictures::take(double time, double strain, const Assembly& assembly) {
  if (!strain_) return;
  const double next = *strain_ * static_cast<double>(shots_.size()) / frames_before_picture;
  if (shots_.size() <= frames_before_picture && strain >= next) shots_.push_back({time, strain, assembly});
}

void Pictures::write(const OutputFolder& output, const std::string& name) const {
  if (shots_.empty()) return;
  View view;
  write_picture(output.file("fig02_before.dat"), shots_.front().assembly, view);
  write_sample_tables(output.path(), "fig02", shots_.front().assembly);
  view.shear_strain = shots_.back().strain;
  write_picture(output.file("fig02_during.dat"), shots_.back().assembly, view);
  std::filesystem::create_directories(output.file(name + "_frames"));
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < shots_.size(); ++i) {
    const std::string grains = fmt::format("{}_frames/grains_{}.vtp", name, i);
    const std::string cell = fmt::format("{}_frames/cell_{}.vtp", name, i);
    write_grains(output.file(grains), shots_[i].assembly);
    write_cell(output.file(cell), shots_[i].assembly.cell);
    frames.push_back({shots_[i].time, grains, 0});
    frames.push_back({shots_[i].time, cell, 1});
  }
  write_collection(output.file(name + ".pvd"), frames);
}

}  // namespace flowslide
