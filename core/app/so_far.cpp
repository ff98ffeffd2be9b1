// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/so_far.hpp"

#include <fmt/format.h>

#include <optional>

#include "app/error.hpp"
#include "app/point_checkpoints.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

namespace fs = std::filesystem;

std::optional<Checkpoint> last_checkpoint(const OutputFolder& output, const std::string& point) {
  std::optional<Checkpoint> last;
  try {
    output.checkpoints(point).read_newest([&](const hdf5::Group& root) { last = read_checkpoint(root); },
                                          [](std::string_view) {});
  } catch (const CorruptFileError&) {
    last.reset();
  }
  return last;
}

/// False if the point has written nothing that can be drawn.
bool copy_point(const OutputFolder& output, const OutputFolder& copy, const std::string& point, std::string& said) {
  for (const char* end : {".h5", ".dat", "_profiles.dat"}) fs::remove(copy.file(point + end));
  if (fs::exists(output.file(point + ".h5"))) {
    for (const char* end : {".dat", "_profiles.dat", ".h5"})
      if (fs::exists(output.file(point + end))) fs::copy_file(output.file(point + end), copy.file(point + end));
    said += fmt::format("{}: complete\n", point);
    return true;
  }
  const auto last = last_checkpoint(output, point);
  said += fmt::format("{}: {}\n", point, last ? "so far at " + place_of(*last) : "nothing yet");
  if (!last) return false;
  Table table = table_of(last->so_far);
  write_table(copy.file(point + ".dat"), table);
  if (last->slide && !last->slide->complete_profiles.columns.empty()) {
    table.series = last->slide->complete_profiles;
    write_table(copy.file(point + "_profiles.dat"), table);
  }
  write_result(copy.file(point + ".h5"), last->so_far);
  return true;
}

}  // namespace

std::string copy_so_far(const OutputFolder& output, const OutputFolder& copy, const std::vector<std::string>& points) {
  std::string said;
  bool any = false;
  for (const std::string& point : points) any = copy_point(output, copy, point, said) || any;
  if (!any)
    throw ConfigurationError(fmt::format("none of the points in {} has a result or a checkpoint yet; a checkpoint is "
                                         "written every --checkpoint-interval", output.path().string()));
  return said;
}

}  // namespace flowslide
