// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <stdexcept>

namespace flowslide {

/// A failure that makes the results of a simulation meaningless: a lost grain, a NaN, an excessive overlap, a sample
/// that does not hold its stress. The message gives the finding, the limit and the remedy.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace flowslide
