// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <set>
#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace flowslide {

/// The present activity of LIGGGHTS, for error messages.
struct LiggghtsActivity {
  std::string doing = "starting";
  std::filesystem::path log;
  std::set<const LAMMPS_NS::LAMMPS*> broken;  ///< simulations that have reported an error
};
LiggghtsActivity& liggghts_activity();

}  // namespace flowslide
