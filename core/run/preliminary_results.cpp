// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/preliminary_results.hpp"

#include <fmt/format.h>

#include <array>
#include <optional>

#include "process/exit_code.hpp"
#include "record/gnuplot_table.hpp"
#include "run/point_checkpoints.hpp"

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

/// The reason why neither result nor checkpoint is usable; empty if one is usable or if both are absent.
std::string problem_of(const FoundResult& found, const std::optional<Checkpoint>& last, const RunIdentity& identity) {
  if (found.standing == Standing::damaged) return found.problem;
  std::string difference = found.problem;
  if (difference.empty() && last) difference = identity.difference_from(RunIdentity(last->partial_result));
  return difference.empty() ? "" : "of another run: " + difference;
}

/// Copies the files of one run. Returns false if it has neither a usable result nor a usable checkpoint.
bool copy_point(const OutputFolder& output, const OutputFolder& copy, const std::string& point,
                const RunIdentity& identity, std::string& progress) {
  copy.remove_point(point);
  const FoundResult found = find_result(output.file(point + OutputFolder::result_end), identity);
  if (found.standing == Standing::complete) {
    // Copies the result last, because the result marks a complete run.
    for (auto end = OutputFolder::point_ends.rbegin(); end != OutputFolder::point_ends.rend(); ++end)
      if (fs::exists(output.file(point + *end)))
        fs::copy(output.file(point + *end), copy.file(point + *end), fs::copy_options::recursive);
    progress += fmt::format("{}: complete\n", point);
    return true;
  }
  const auto last = last_checkpoint(output, point);
  if (const std::string problem = problem_of(found, last, identity); !problem.empty()) {
    progress += fmt::format("{}: left out: {}\n", point, problem);
    return false;
  }
  progress += fmt::format("{}: {}\n", point, last ? "so far at " + place_of(*last) : "nothing yet");
  if (!last) return false;
  Table table = table_of(last->partial_result);
  write_table(copy.file(point + ".dat"), table);
  if (last->slide && !last->slide->complete_profiles.columns.empty()) {
    table.series = last->slide->complete_profiles;
    write_table(copy.file(point + "_profiles.dat"), table);
  }
  write_result(copy.file(point + ".h5"), last->partial_result);
  return true;
}

}  // namespace

std::string copy_preliminary_results(const OutputFolder& output, const OutputFolder& copy,
                                     const std::map<std::string, RunIdentity>& points) {
  std::string progress;
  bool any = false;
  for (const auto& [point, identity] : points) any = copy_point(output, copy, point, identity, progress) || any;
  if (!any)
    throw Refused(
        fmt::format("none of the runs in {} has a result or a checkpoint yet; a checkpoint is "
                    "written every --checkpoint-interval\n{}",
                    output.path().string(), progress));
  return progress;
}

}  // namespace flowslide
