// SPDX-License-Identifier: GPL-2.0-or-later
// How far a run has come, on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace flowslide {

/// Where and how progress is shown.
struct ProgressStyle {
  bool silent = false;    ///< nothing at all is written
  int rank = 0;           ///< MPI rank; any but 0 is silent
  bool terminal = false;  ///< one rewritten line; else a line every `line_interval`
  int columns = 80;       ///< width of the terminal
  std::chrono::milliseconds rewrite_interval{200};
  std::chrono::seconds line_interval{30};
  std::ostream* stream = nullptr;  ///< nullptr: stderr
  std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;

  /// The style that suits stderr as it is now.
  static ProgressStyle of_stderr(int rank = 0, bool silent = false);
  /// Writes a line at once, unless silent.
  void say(std::string_view line) const;
};

/// "fig03 loosest:  42 %  12.3k steps/s  1 min 05 s left  strain 0.21". Not for use by several threads at once.
class Progress {
 public:
  /// `total` steps are to be done, `done` of them by an earlier run (they do not count in the speed).
  /// Precondition: 0 <= done <= total, else std::invalid_argument.
  Progress(std::string label, std::int64_t total, ProgressStyle style = ProgressStyle::of_stderr(),
           std::int64_t done = 0);
  /// Ends the line on a terminal, whatever happened.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether an update would be written now: texts and totals that cost something are made only then.
  bool due() const;
  /// Says that `done` steps of the total are done. Cheap: most calls only read the clock.
  void update(std::int64_t done, std::string_view text = {});
  /// Changes the number of steps in all, when it turns out to be another.
  void set_total(std::int64_t total);
  /// Writes a line of its own without disturbing the rewritten one.
  void message(std::string_view line);
  /// Writes the last state and the time that it took. Later calls do nothing.
  void finish(std::string_view text = {});

 private:
  std::string line(std::string_view text) const;
  void write(const std::string& line);
  std::chrono::duration<double> elapsed() const;

  std::string label_;
  std::int64_t total_;
  std::int64_t done_;
  std::int64_t first_;
  ProgressStyle style_;
  std::chrono::steady_clock::time_point start_;
  std::chrono::steady_clock::time_point last_write_;
  bool line_open_ = false;
  bool finished_ = false;
};

/// "12 s", "3 min 05 s", "2 h 07 min", "4 d 02 h"; "unknown" when not finite or negative.
std::string duration_text(double seconds);

/// "950", "12.3k", "4.56M" steps.
std::string count_text(double count);

}  // namespace flowslide
