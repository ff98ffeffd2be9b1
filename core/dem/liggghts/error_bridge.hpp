// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace flowslide {

/// The present activity of LIGGGHTS, for error messages.
struct LiggghtsActivity {
  std::string doing = "starting";
  std::filesystem::path log;
  int errors = 0;  ///< number of errors in this process so far
};
LiggghtsActivity& liggghts_activity();

}  // namespace flowslide
