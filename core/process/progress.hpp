// SPDX-License-Identifier: GPL-2.0-or-later
// Progress of a run, on stderr.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <ostream>
#include <string>
#include <string_view>

namespace flowslide {

/// Place and form of the progress messages.
struct ProgressStyle {
  bool silent = false;    ///< true: writes nothing
  int rank = 0;           ///< MPI rank; all ranks except 0 are silent
  bool terminal = false;  ///< true: one rewritten line; false: a new line every `line_interval`
  int columns = 80;       ///< width of the terminal
  std::chrono::milliseconds rewrite_interval{200};
  std::chrono::seconds line_interval{30};
  std::ostream* stream = nullptr;  ///< nullptr means stderr
  std::function<std::chrono::steady_clock::time_point()> now = std::chrono::steady_clock::now;

  /// The style for stderr: a terminal with its width, or a file.
  static ProgressStyle of_stderr(int rank = 0);
  /// Writes a line at once, unless silent.
  void say(std::string_view line) const;
};

/// A progress line: "fig03 loosest:  42 %  12.3k steps/s  1 min 05 s left  strain 0.21". Not thread-safe.
class Progress {
 public:
  /// `total` is the number of all steps. An earlier run has done `done` of them; they do not count in the speed. Throws
  /// std::invalid_argument unless 0 <= done <= total.
  Progress(std::string label, std::int64_t total, ProgressStyle style = ProgressStyle::of_stderr(),
           std::int64_t done = 0);
  /// Ends the line on a terminal if it is still open.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Whether `update` would write now. Callers compute costly texts and totals only then.
  bool due() const;
  /// Reports that `done` of all steps are done. Cheap: most calls only read the clock. Throws std::invalid_argument
  /// unless 0 <= done <= total.
  void update(std::int64_t done, std::string_view text = {});
  /// Changes the number of all steps. Throws std::invalid_argument if fewer are to be done than are done.
  void set_total(std::int64_t total);
  /// Writes a separate line above the rewritten line.
  void message(std::string_view line);
  /// Writes the last state and the elapsed time. Later calls do nothing.
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

/// A predicted duration: as duration_text, but "below 1 s" for less than 0.5 s.
std::string prediction_text(double seconds);

/// "950", "12.3k", "4.56M" steps.
std::string count_text(double count);

}  // namespace flowslide
