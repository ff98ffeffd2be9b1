// SPDX-License-Identifier: GPL-2.0-or-later
#include "app/status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "app/canonical.hpp"
#include "app/point_checkpoints.hpp"
#include "app/progress.hpp"
#include "app/sample_health.hpp"
#include "record/file_lock.hpp"

namespace flowslide {
namespace {

std::string quoted(const std::string& text) { return canonical(std::string_view(text)); }

void read_last_checkpoint(const CheckpointStore& store, PointStatus& status) {
  const auto last = store.last_write();
  if (!last) return;
  const std::chrono::duration<double> age = std::filesystem::file_time_type::clock::now() - *last;
  status.age = std::max(0.0, age.count());
  try {
    store.read_newest(
        [&](const hdf5::Group& root) {
          const Checkpoint checkpoint = read_checkpoint(root);
          status.place = place_of(checkpoint);
          status.share_done = checkpoint.share_done;
          status.sample = health_line(checkpoint.so_far.metrics);
        },
        [](std::string_view) {});
  } catch (const CorruptFileError&) {
    status.place = "its checkpoints are damaged";
  }
}

}  // namespace

PointStatus status_of(const OutputFolder& output, const std::string& point) {
  PointStatus status{point, "not begun", "", 0.0, 0.0, ""};
  const std::string hash = output.hash_of(point);
  if (const auto file = output.file(point + ".h5"); std::filesystem::exists(file)) {
    const bool whole = is_complete(file, hash);
    status.state = whole ? "complete" : "damaged";
    status.share_done = whole ? 1.0 : 0.0;
    if (whole) status.sample = health_line(read_result(file).metrics);
    return status;
  }
  const CheckpointStore store = output.checkpoints(point);
  read_last_checkpoint(store, status);
  if (FileLock::is_held(output.lock_path(point))) status.state = "running";
  else if (!store.empty()) status.state = "stopped";
  else if (!hash.empty()) status.state = "begun";
  return status;
}

std::string status_table(const std::vector<PointStatus>& points) {
  std::size_t width = 5;
  for (const PointStatus& point : points) width = std::max(width, point.point.size());
  std::string text = fmt::format("{:{}}  {:9}  {:>5}  {:>12}  at its last checkpoint\n", "point", width, "state",
                                 "done", "kept before");
  for (const PointStatus& point : points) {
    const bool kept = !point.place.empty();
    text += fmt::format("{:{}}  {:9}  {:>3.0f} %  {:>12}  {}\n", point.point, width, point.state,
                        100.0 * point.share_done, kept ? duration_text(point.age) : "-", kept ? point.place : "-");
  }
  for (const PointStatus& point : points)
    if (!point.sample.empty()) text += fmt::format("sample of {}: {}\n", point.point, point.sample);
  return text;
}

std::string status_json(const std::vector<PointStatus>& points) {
  std::string text = "{\"points\": [";
  for (const PointStatus& point : points)
    text += fmt::format(
        "{}\n  {{\"name\": {}, \"state\": {}, \"share_done\": {:.3f}, \"checkpoint_age\": {:.1f}, "
        "\"place\": {}, \"sample\": {}}}",
        &point == &points.front() ? "" : ",", quoted(point.point), quoted(point.state), point.share_done, point.age,
        quoted(point.place), quoted(point.sample));
  return text + "\n]}\n";
}

}  // namespace flowslide
