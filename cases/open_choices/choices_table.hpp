// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "experiment/ensemble.hpp"

namespace flowslide {

/// The open choices one at a time, as a table in Markdown: one row for each choice and sample. `runs` are named
/// <choice>_<sample>_shear (an element test), _RD and _RI (slides). A number that no run has is "-".
std::string choices_table(const Ensembles& runs);

}  // namespace flowslide
