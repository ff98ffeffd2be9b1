// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dem/liggghts/liggghts_engine.hpp"

namespace flowslide {

std::vector<std::string> engine_names() { return {"liggghts"}; }

std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log) {
  if (name == "liggghts") return std::make_unique<LiggghtsEngine>(log);
  throw std::invalid_argument(
      fmt::format("there is no engine '{}'; choose one of: {}", name, fmt::join(engine_names(), ", ")));
}

}  // namespace flowslide
