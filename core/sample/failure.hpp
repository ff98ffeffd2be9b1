// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <stdexcept>

namespace flowslide {

/// A simulation went wrong in a way that would make its results meaningless: a lost grain, a NaN, an overlap beyond
/// reason, a sample that does not hold its stress. The message says what was found, the limit, and how to mend it.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace flowslide
