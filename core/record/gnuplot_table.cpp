// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/gnuplot_table.hpp"

#include <fmt/format.h>

#include <charconv>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace flowslide {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  return std::string(text.substr(first, text.find_last_not_of(' ') - first + 1));
}

/// Text for one part of a header line: a line break would end the comment, and a bar would end the part.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r' || c == '|') c = ' ';
  return trimmed(text);
}

std::string column_line(std::size_t index, const Column& column) {
  return fmt::format("# column {}: {} | {} | {} | {} | {}\n", index, column.name, one_line(column.symbol),
                     one_line(column.units), one_line(column.long_name), one_line(column.sign_convention));
}

std::string names_line(const std::vector<const Column*>& columns) {
  std::string line;
  for (const Column* column : columns) {
    if (!is_valid_name(column->name))
      throw std::invalid_argument(fmt::format(
          "'{}' cannot name a column; use letters, digits and '_', a letter first", column->name));
    line += (line.empty() ? "" : " ") + column->name;
  }
  return line + '\n';
}

std::string head_of(const TableHeader& header, const std::vector<const Column*>& columns) {
  std::string text = names_line(columns);
  for (const auto& [key, value] : header) text += fmt::format("# {}: {}\n", one_line(key), one_line(value));
  for (std::size_t i = 0; i < columns.size(); ++i) text += column_line(i + 1, *columns[i]);
  return text;
}

std::vector<const Column*> columns_of(const Series& series) {
  std::vector<const Column*> columns{&series.axis};
  for (const Column& column : series.columns) columns.push_back(&column);
  return columns;
}

/// Reads a table line by line and counts lines for messages.
class Reader {
 public:
  Reader(std::string_view text, std::string path) : rest_(text), path_(std::move(path)) {}

  Table table() {
    while (!rest_.empty()) {
      const auto end = rest_.find('\n');
      if (end == std::string_view::npos) fail("the last line is cut off");
      take(rest_.substr(0, end));
      rest_.remove_prefix(end + 1);
    }
    if (!has_axis_) fail("no columns");
    try {
      table_.series.check();
      if (std::string(names_) + '\n' != names_line(columns_of(table_.series)))
        fail("the first line does not name the columns; in tables of older versions it is a comment");
    } catch (const std::invalid_argument& error) {
      fail(error.what());
    }
    return std::move(table_);
  }

 private:
  void take(std::string_view line) {
    ++line_;
    if (line_ == 1) names_ = line;
    else if (line.starts_with("# column ")) take_column(line);
    else if (line.starts_with("# ")) take_header(line.substr(2));
    else take_row(line);
  }

  void take_header(std::string_view line) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) fail("a header line without ':'");
    table_.header.emplace_back(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1)));
  }

  void take_column(std::string_view line) {
    const auto colon = line.find(':');
    if (colon == std::string_view::npos) fail("a column line without ':'");
    std::vector<std::string> parts;
    for (auto rest = line.substr(colon + 1);;) {
      const auto bar = rest.find('|');
      parts.push_back(trimmed(rest.substr(0, bar)));
      if (bar == std::string_view::npos) break;
      rest.remove_prefix(bar + 1);
    }
    if (parts.size() != 5) fail("a column line without its five parts");
    Column column{parts[0], parts[1], parts[2], parts[3], parts[4], {}};
    if (has_axis_) table_.series.columns.push_back(std::move(column));
    else table_.series.axis = std::move(column);
    has_axis_ = true;
  }

  void take_row(std::string_view line) {
    std::vector<double> row;
    const char* next = line.data();
    const char* const end = line.data() + line.size();
    while (next != end) {
      if (*next == ' ') {
        ++next;
        continue;
      }
      double value = 0.0;
      const auto [stop, error] = std::from_chars(next, end, value);
      if (error != std::errc{} || (stop != end && *stop != ' ')) fail("not a number");
      row.push_back(value);
      next = stop;
    }
    if (!has_axis_ || row.size() != table_.series.columns.size() + 1) fail("not one number per column");
    table_.series.append_row(row.front(), std::span(row).subspan(1));
  }

  [[noreturn]] void fail(std::string_view reason) const {
    throw CorruptFileError(fmt::format("{}:{}: {}", path_, line_, reason));
  }

  std::string_view rest_;
  std::string path_;
  std::size_t line_ = 0;
  std::string_view names_;
  bool has_axis_ = false;
  Table table_;
};

}  // namespace

std::string shortest(double value) {
  char text[32];
  const auto result = std::to_chars(text, text + sizeof text, value);
  return {text, result.ptr};
}

std::string table_head(const std::vector<Column>& columns, const TableHeader& header) {
  std::vector<const Column*> pointers;
  for (const Column& column : columns) pointers.push_back(&column);
  return head_of(header, pointers);
}

void write_table(const std::filesystem::path& path, const Table& table, IfExists if_exists) {
  table.series.check();
  std::string text = head_of(table.header, columns_of(table.series));
  for (std::size_t row = 0; row < table.series.rows(); ++row) {
    text += shortest(table.series.axis.values[row]);
    for (const Column& column : table.series.columns) text += ' ' + shortest(column.values[row]);
    text += '\n';
  }
  write_atomically(path, text, if_exists);
}

Table table_of(const Result& result) {
  const Provenance& from = result.provenance;
  return {{{"case", from.case_name},
           {"point", from.point},
           {"figure", from.figure},
           {"scale", from.scale},
           {"seed", fmt::format("{}", from.seed)},
           {"replicate", fmt::format("{}", from.replicate)},
           {"engine", from.engine + " " + from.engine_version},
           {"configuration", result.configuration_hash},
           {"revision", from.git_revision + " (" + from.git_state + ")"}},
          result.series};
}

Table read_table(const std::filesystem::path& path) {
  const std::string text = read_file(path);
  return Reader(text, path.string()).table();
}

}  // namespace flowslide
