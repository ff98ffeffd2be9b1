// SPDX-License-Identifier: GPL-2.0-or-later
#include "process/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

namespace flowslide {
namespace {

void check_steps(std::int64_t done, std::int64_t total) {
  if (done < 0 || done > total)
    throw std::invalid_argument(fmt::format("progress of {} steps of {}: needs 0 <= done <= total", done, total));
}

/// The first `columns` code points of a UTF-8 text.
std::string_view cut(std::string_view text, int columns) {
  int seen = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool begins_letter = (static_cast<unsigned char>(text[i]) & 0xC0U) != 0x80U;
    if (begins_letter && ++seen > columns) return text.substr(0, i);
  }
  return text;
}

}  // namespace

std::string duration_text(double seconds) {
  if (!std::isfinite(seconds) || seconds < 0.0) return "unknown";
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const auto whole = static_cast<std::int64_t>(std::llround(std::min(seconds, 1e15)));
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  const std::int64_t minutes = (whole + 30) / 60;
  if (minutes < std::int64_t{24} * 60) return fmt::format("{} h {:02} min", minutes / 60, minutes % 60);
  const std::int64_t hours = (minutes + 30) / 60;
  return fmt::format("{} d {:02} h", hours / 24, hours % 24);
}

std::string prediction_text(double seconds) {
  return seconds >= 0.0 && seconds < 0.5 ? "below 1 s" : duration_text(seconds);
}

std::string count_text(double count) {
  if (count < 999.5) return fmt::format("{:.3g}", count);
  const bool thousands = count < 999.5e3;
  const double scaled = count / (thousands ? 1e3 : 1e6);
  const int decimals = scaled < 9.995 ? 2 : scaled < 99.95 ? 1 : 0;
  return fmt::format("{:.{}f}{}", scaled, decimals, thousands ? "k" : "M");
}

ProgressStyle ProgressStyle::of_stderr(int rank) {
  ProgressStyle style;
  style.rank = rank;
  const char* kind = std::getenv("TERM");
  style.terminal = ::isatty(STDERR_FILENO) == 1 && kind != nullptr && std::string_view(kind) != "dumb";
  winsize size{};
  if (style.terminal && ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) style.columns = size.ws_col;
  return style;
}

void ProgressStyle::say(std::string_view line) const {
  if (!silent && rank == 0) (stream != nullptr ? *stream : std::cerr) << line << std::endl;
}

Progress::Progress(std::string label, std::int64_t total, ProgressStyle style, std::int64_t done)
    : label_(std::move(label)), total_(total), done_(done), first_(done), style_(std::move(style)) {
  check_steps(done, total);
  if (style_.rank != 0) style_.silent = true;
  if (style_.stream == nullptr) style_.stream = &std::cerr;
  start_ = last_write_ = style_.now();
  if (style_.terminal) last_write_ -= style_.rewrite_interval;  // the first update shows at once
}

Progress::~Progress() {
  if (line_open_) *style_.stream << std::endl;
}

bool Progress::due() const {
  const auto interval = style_.terminal ? style_.rewrite_interval : std::chrono::milliseconds(style_.line_interval);
  return !style_.silent && !finished_ && style_.now() - last_write_ >= interval;
}

void Progress::update(std::int64_t done, std::string_view text) {
  check_steps(done, total_);
  done_ = done;
  if (!due()) return;
  last_write_ = style_.now();
  write(line(text));
}

void Progress::set_total(std::int64_t total) {
  check_steps(done_, total);
  total_ = total;
}

void Progress::message(std::string_view text) {
  if (style_.silent) return;
  if (line_open_) *style_.stream << "\r\x1b[K";
  line_open_ = false;
  *style_.stream << text << std::endl;
}

void Progress::finish(std::string_view text) {
  if (finished_) return;
  finished_ = true;
  if (style_.silent) return;
  std::string last = fmt::format("{}: {:3.0f} %  {} steps in {}", label_,
                                 total_ > 0 ? 100.0 * static_cast<double>(done_) / static_cast<double>(total_) : 100.0,
                                 count_text(static_cast<double>(done_ - first_)), duration_text(elapsed().count()));
  if (!text.empty()) last += fmt::format("  {}", text);
  message(last);
}

std::string Progress::line(std::string_view text) const {
  // Rounded down: 100 % appears only when all steps are done.
  const double share = total_ > 0 ? static_cast<double>(done_) / static_cast<double>(total_) : 1.0;
  const double speed = static_cast<double>(done_ - first_) / elapsed().count();
  std::string line = fmt::format("{}: {:3.0f} %", label_, std::floor(100.0 * share));
  if (done_ > first_ && std::isfinite(speed)) {
    line += fmt::format("  {} steps/s  {} left", count_text(speed),
                        duration_text(static_cast<double>(total_ - done_) / speed));
  }
  if (!text.empty()) line += fmt::format("  {}", text);
  return line;
}

void Progress::write(const std::string& text) {
  if (style_.terminal) {
    *style_.stream << "\r" << cut(text, style_.columns - 1) << "\x1b[K" << std::flush;
    line_open_ = true;
  } else {
    *style_.stream << text << std::endl;
  }
}

std::chrono::duration<double> Progress::elapsed() const { return style_.now() - start_; }

}  // namespace flowslide
