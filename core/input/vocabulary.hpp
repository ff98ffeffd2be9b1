// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "configuration/configuration.hpp"

namespace flowslide {

/// Keys that only some runs use.
struct KeysOfRuns {
  std::vector<std::string> tables;  ///< where they stand; "*" stands for any name: "point.*.loading"
  std::vector<std::string> names;
  std::string users;  ///< the runs that use them (see Configuration::describe_users)
};

/// All such keys of the readers in this folder. A message about one of them in a case without such runs says which runs
/// use it.
const std::vector<KeysOfRuns>& vocabulary();

/// Tells the configuration which runs use the keys of the vocabulary.
void describe_vocabulary(const Configuration& configuration);

}  // namespace flowslide
