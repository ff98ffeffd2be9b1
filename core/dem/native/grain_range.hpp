// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <cstddef>

namespace flowslide::native {

/// The grains `begin` to `end` - 1, which one thread owns. The thread moves them and sums the forces on them.
struct GrainRange {
  std::size_t begin = 0, end = 0;
  bool owns(std::size_t grain) const { return grain >= begin && grain < end; }
};

}  // namespace flowslide::native
