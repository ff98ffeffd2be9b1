// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace flowslide {

/// What LIGGGHTS is doing now; quoted when it reports an error.
struct LiggghtsActivity {
  std::string doing = "starting";
  std::filesystem::path log;
  int errors = 0;  ///< reported so far in this process
};
LiggghtsActivity& liggghts_activity();

}  // namespace flowslide
