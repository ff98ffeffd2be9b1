// SPDX-License-Identifier: GPL-2.0-or-later
// Any bytes as a configuration file, read with each getter: a ConfigurationError or a value, and what was resolved can
// be read again.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string_view>

#include "configuration/configuration.hpp"
#include "configuration/error.hpp"

namespace {

using flowslide::Configuration;
using flowslide::ConfigurationError;
using flowslide::Range;

bool holds(const std::function<void()>& read) {
  try {
    read();
    return true;
  } catch (const ConfigurationError&) {
    return false;
  }
}

void read_all(const Configuration& configuration) {
  namespace dimension = flowslide::dimension;
  for (const char* key : {"engine", "seed", "slope.angle", "a", "a.b", "point.a.figures", "claim.0.metric",
                          "x-y_z.1"}) {
    holds([&] { configuration.has(key); });
    holds([&] { configuration.quantity(key, dimension::stress, Range::positive()); });
    holds([&] { configuration.quantity(key, dimension::angle); });
    holds([&] { configuration.number(key, Range::between(-1.0, 1.0)); });
    holds([&] { configuration.integer(key, Range::not_negative()); });
    holds([&] { configuration.flag(key); });
    holds([&] { configuration.text(key, {"native", "liggghts"}); });
    holds([&] { configuration.quantities(key, dimension::time); });
    holds([&] { configuration.numbers(key); });
    holds([&] { configuration.integers(key); });
    holds([&] { configuration.texts(key); });
    holds([&] { configuration.subtables(key); });
    holds([&] { configuration.refuse(key, "it is tried", "do nothing"); });
  }
  holds([&] { configuration.reject_unknown(); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    flowslide::parse_quantity(text);
  } catch (const std::invalid_argument&) {
  }
  holds([&] {
    const Configuration configuration = Configuration::from_text(text);
    read_all(configuration);
    const std::string resolved = configuration.resolved();
    const Configuration again = Configuration::from_text(resolved);  // must be readable, whatever it was made of
    static_cast<void>(again.resolved());
  });
  return 0;
}
