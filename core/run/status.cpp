// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/status.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "process/progress.hpp"
#include "record/file_lock.hpp"
#include "record/health_line.hpp"
#include "run/point_checkpoints.hpp"

namespace flowslide {
namespace {

/// `value` rounded to a multiple of 1/`per_unit`.
double rounded(double value, double per_unit) { return std::round(value * per_unit) / per_unit; }

void read_last_checkpoint(const CheckpointStore& store, const RunIdentity& identity, PointStatus& status) {
  const auto last = store.last_write();
  if (!last) return;
  const std::chrono::duration<double> age = std::filesystem::file_time_type::clock::now() - *last;
  status.age = std::max(0.0, age.count());
  try {
    store.read_newest(
        [&](const hdf5::Group& root) {
          const Checkpoint checkpoint = read_checkpoint(root);
          const std::string difference = identity.difference_from(RunIdentity(checkpoint.partial_result));
          status.state = difference.empty() ? "stopped" : "outdated";
          status.place = difference.empty() ? place_of(checkpoint) : difference;
          status.share_done = checkpoint.share_done;
          status.sample = health_line(checkpoint.partial_result.metrics);
        },
        [](std::string_view) {});
  } catch (const CorruptFileError&) {
    status.state = "stopped";
    status.place = "its checkpoints are damaged";
  }
}

}  // namespace

PointStatus status_of(const OutputFolder& output, const std::string& point, const RunIdentity& identity) {
  PointStatus status{point, "not begun", "", 0.0, 0.0, ""};
  const auto file = output.file(point + OutputFolder::result_end);
  const FoundResult found = find_result(file, identity);
  switch (found.standing) {
    case Standing::complete: return {point, "complete", "", 1.0, 0.0, health_line(read_result(file).metrics)};
    case Standing::damaged: return {point, "damaged", "", 0.0, 0.0, ""};
    case Standing::other: return {point, "outdated", found.problem, 0.0, 0.0, ""};
    case Standing::absent: break;
  }
  if (output.noted(point) == identity.text()) status.state = "begun";
  read_last_checkpoint(output.checkpoints(point), identity, status);
  if (FileLock::is_held(output.lock_path(point))) status.state = "running";
  return status;
}

std::string status_table(const std::vector<PointStatus>& points) {
  std::size_t width = 5;
  for (const PointStatus& point : points) width = std::max(width, point.point.size());
  std::string text = fmt::format("{:{}}  {:9}  {:>5}  {:>12}  at its last checkpoint\n", "run", width, "state",
                                 "done", "kept before");
  for (const PointStatus& point : points) {
    text +=
        fmt::format("{:{}}  {:9}  {:>3.0f} %  {:>12}  {}\n", point.point, width, point.state, 100.0 * point.share_done,
                    point.age > 0.0 ? duration_text(point.age) : "-", point.place.empty() ? "-" : point.place);
  }
  for (const PointStatus& point : points)
    if (!point.sample.empty()) text += fmt::format("sample of {}: {}\n", point.point, point.sample);
  return text;
}

std::string status_json(const std::vector<PointStatus>& points) {
  nlohmann::ordered_json all;
  all["points"] = nlohmann::ordered_json::array();
  for (const PointStatus& point : points)
    all["points"].push_back({{"name", point.point},
                             {"state", point.state},
                             {"share_done", rounded(point.share_done, 1000)},
                             {"checkpoint_age", rounded(point.age, 10)},
                             {"place", point.place},
                             {"sample", point.sample}});
  return all.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

}  // namespace flowslide
