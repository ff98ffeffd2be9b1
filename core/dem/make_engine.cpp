// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dem/liggghts/liggghts_engine.hpp"
#include "dem/native/native_engine.hpp"

namespace flowslide {

std::vector<std::string> engine_names() { return {"liggghts", "liggghts-stock", "native", "native-mixed"}; }

std::unique_ptr<Engine> make_engine(const std::string& name, const std::filesystem::path& log, int threads) {
  if (name == "liggghts") return std::make_unique<LiggghtsEngine>(log);
  if (name == "liggghts-stock") return std::make_unique<LiggghtsEngine>(log, SeparatedHistory::kept);
  if (name == "native") return std::make_unique<DoubleEngine>(NativeOptions{.threads = threads});
  if (name == "native-mixed") return std::make_unique<MixedEngine>(NativeOptions{.threads = threads});
  throw std::invalid_argument(
      fmt::format("there is no engine '{}'; choose one of: {}", name, fmt::join(engine_names(), ", ")));
}

}  // namespace flowslide
