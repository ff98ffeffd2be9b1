// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "record/series.hpp"

namespace flowslide {

/// Columns of a slide in the order of the tables; the axis is the global clock.
Series slide_series();

}  // namespace flowslide
