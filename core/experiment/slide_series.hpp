// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include "record/series.hpp"

namespace flowslide {

/// An empty record of a slide, with the columns in the order of the tables. The axis is the global clock, s.
Series slide_series();

}  // namespace flowslide
