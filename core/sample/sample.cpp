// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/sample.hpp"

#include "grains/require.hpp"

namespace flowslide {

void validate(const LocalRun& run) {
  require(run.steps >= 0, "number of steps of a run", static_cast<double>(run.steps), ">= 0",
          "To reverse a strain, change the sign of its rate.");
}

}  // namespace flowslide
