// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstdlib>

/// Ends the fuzzer, so that it keeps the input, unless `holds`.
inline void require(bool holds) {
  if (!holds) std::abort();
}
