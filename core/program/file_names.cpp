// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/file_names.hpp"

#include <fmt/format.h>

#include <map>

#include "configuration/error.hpp"
#include "program/case.hpp"

namespace flowslide {
namespace {

/// Names of files and folders that every case program writes.
const std::vector<std::string> program_names{"claims", "changes", "cost", "metrics", "runs", "so_far", "table"};

class Owners {
 public:
  void add(const std::string& name, const std::string& owner) {
    const auto [known, is_new] = owners_.emplace(name, owner);
    if (!is_new)
      throw ConfigurationError(
          fmt::format("the name \"{}\" is taken twice: by {} and by {}; both would be written to one file; give the "
                      "table [point.<name>] another name (replicate N of a run is named <name>_rN)",
                      name, known->second, owner));
  }

 private:
  std::map<std::string, std::string> owners_;
};

}  // namespace

void refuse_names_that_meet(const std::vector<Point>& points, const std::vector<std::string>& tables) {
  Owners owners;
  for (const std::string& name : program_names) owners.add(name, "the program");
  for (const std::string& table : tables) owners.add(table, "a table of the figures");
  for (const Point& point : points) owners.add(point.name, fmt::format("a run ({})", point.description));
  for (const Point& point : points)
    for (const std::string& table : point.tables) owners.add(table, fmt::format("a table of the run {}", point.name));
}

}  // namespace flowslide
