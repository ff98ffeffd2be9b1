// SPDX-License-Identifier: GPL-2.0-or-later
#include "run/begin_point.hpp"

#include <fmt/format.h>

#include "process/exit_code.hpp"

namespace flowslide {
namespace {

[[noreturn]] void refuse(const std::string& what, const std::string& difference) {
  throw Refused(
      fmt::format("{} of another run ({}), and is not overwritten; {}", what, difference, begin_anew));
}

}  // namespace

BegunPoint begin_point(const OutputFolder& output, const std::string& point, const RunIdentity& identity, bool afresh) {
  FileLock lock = output.lock_point(point);
  const auto file = output.file(point + OutputFolder::result_end);
  const FoundResult found = find_result(file, identity);
  if (found.standing == Standing::complete) {
    output.checkpoints(point).remove();
    return {std::move(lock), true};
  }
  const std::string noted = output.noted(point);
  const bool other_was_begun = !noted.empty() && noted != identity.text();
  if (afresh) {
    output.remove_point(point);
  } else if (found.standing == Standing::damaged) {
    throw CorruptFileError(found.problem + ", or begin it anew with --afresh");
  } else if (found.standing == Standing::other) {
    refuse(file.string() + " is the result", found.problem);
  } else if (other_was_begun && !output.checkpoints(point).empty()) {
    refuse(fmt::format("the checkpoint of {} in {} is", point, output.path().string()),
           identity.difference_from(RunIdentity::from_text(noted)));
  } else if (other_was_begun) {
    output.remove_point(point);  // tables of another run, which left no checkpoint
  }
  output.note(point, identity.text());
  return {std::move(lock), false};
}

}  // namespace flowslide
