// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/make_engine.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "dem/native/native_engine.hpp"
#ifdef FLOWSLIDE_LIGGGHTS
#include "dem/liggghts/liggghts_engine.hpp"
#endif

namespace flowslide {
namespace {

#ifdef FLOWSLIDE_LIGGGHTS
constexpr bool has_liggghts = true;
#else
constexpr bool has_liggghts = false;
#endif

bool is_liggghts(const std::string& name) { return name == "liggghts" || name == "liggghts-stock"; }

/// Throws unless this build has the engine.
void require_engine(const std::string& name) {
  const std::vector<std::string> known = engine_names();
  if (std::find(known.begin(), known.end(), name) == known.end())
    throw std::invalid_argument(
        fmt::format("there is no engine '{}'; choose one of: {}", name, fmt::join(known, ", ")));
  if (is_liggghts(name) && !has_liggghts)
    throw MissingEngine(fmt::format(
        "this build has no engine '{}', because it was configured with FLOWSLIDE_LIGGGHTS=OFF; choose one of: {}. To "
        "get it, install the Debian packages libliggghts-dev, libopenmpi-dev and openmpi-bin, configure with cmake "
        "-DFLOWSLIDE_LIGGGHTS=ON and build again",
        name, fmt::join(engine_names_of_build(), ", ")));
}

}  // namespace

std::vector<std::string> engine_names() { return {"liggghts", "liggghts-stock", "native", "native-mixed"}; }

std::vector<std::string> engine_names_of_build() {
  std::vector<std::string> names = engine_names();
  if (!has_liggghts) std::erase_if(names, is_liggghts);
  return names;
}

std::unique_ptr<Engine> make_engine(const std::string& name, [[maybe_unused]] const std::filesystem::path& log,
                                    int threads, [[maybe_unused]] const void* communicator) {
  require_engine(name);
#ifdef FLOWSLIDE_LIGGGHTS
  if (is_liggghts(name))
    return std::make_unique<LiggghtsEngine>(
        log, name == "liggghts" ? SeparatedHistory::cleared : SeparatedHistory::kept,
        communicator ? *static_cast<const MPI_Comm*>(communicator) : MPI_COMM_SELF);
#endif
  if (name == "native-mixed") return std::make_unique<MixedEngine>(NativeOptions{.threads = threads});
  return std::make_unique<DoubleEngine>(NativeOptions{.threads = threads});
}

std::vector<std::string> setup_text(const std::string& name, [[maybe_unused]] const Assembly& assembly,
                                    [[maybe_unused]] const EngineSettings& settings) {
  require_engine(name);
  std::vector<std::string> lines;
#ifdef FLOWSLIDE_LIGGGHTS
  if (!is_liggghts(name)) return lines;
  lines = setup_commands(assembly, settings,
                         name == "liggghts" ? SeparatedHistory::cleared : SeparatedHistory::kept);
  for (const std::string& line : grain_commands()) lines.push_back(line);
#endif
  return lines;
}

}  // namespace flowslide
