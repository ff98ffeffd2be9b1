// SPDX-License-Identifier: GPL-2.0-or-later
// Any bytes as a loading table: a ConfigurationError, or a table whose times grow, that a slope can be loaded by, and
// that a result gives back as it was.
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

#include "configuration/error.hpp"
#include "experiment/loading_record.hpp"
#include "input/read_loading_table.hpp"
#include "require.hpp"
#include "slope/driving_stress.hpp"

namespace {

/// A file in memory that holds the last input.
std::string file_of(const std::uint8_t* data, std::size_t size) {
  static const int descriptor = ::memfd_create("loading table", 0);
  require(::ftruncate(descriptor, 0) == 0 && ::pwrite(descriptor, data, size, 0) == static_cast<ssize_t>(size));
  return "/proc/self/fd/" + std::to_string(descriptor);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = file_of(data, size);
  flowslide::StressTable table;
  try {
    table = flowslide::read_loading_table(file);
  } catch (const flowslide::ConfigurationError&) {
    return 0;
  }
  require(!table.time.empty() && table.time.size() == table.change.size());
  for (std::size_t row = 0; row < table.time.size(); ++row) {
    require(std::isfinite(table.time[row]) && std::isfinite(table.change[row]));
    require(row == 0 || table.time[row] > table.time[row - 1]);
  }
  const flowslide::StressHistory history = table;
  flowslide::validate(history);  // an exception here ends the fuzzer
  for (std::size_t row = 0; row < table.time.size(); ++row) {
    require(flowslide::stress_change(history, table.time[row]) == table.change[row]);
    if (row > 0)
      require(std::isfinite(flowslide::stress_change(history, 0.5 * table.time[row - 1] + 0.5 * table.time[row])));
  }
  const flowslide::InputTable kept = flowslide::input_table(file, table);
  require(kept.rows.column("time").values == table.time && kept.rows.column("stress_change").values == table.change);
  return 0;
}
