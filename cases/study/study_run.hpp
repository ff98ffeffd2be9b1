// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "sweep.hpp"

namespace flowslide {

/// One run of a study, without its replicates.
struct StudyRun {
  std::string name;           ///< "RD_3deg"
  std::string scheme;         ///< "RD"
  SweepValue value;           ///< of the sweep; empty without a sweep
  std::string configuration = {};  ///< the values that decide its result (see Point)
};

}  // namespace flowslide
