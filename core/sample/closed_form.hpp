// SPDX-License-Identifier: GPL-2.0-or-later
// Samples that stand in for DEM where grains do not matter: their names, and the versions of their sources.
#pragma once
#include <string>
#include <vector>

namespace flowslide {

/// "elastic" and "critical_state": what may be given where an engine is, and the tables that hold their values.
std::vector<std::string> closed_form_sample_names();
bool is_closed_form(const std::string& name);

/// The version of this project and a hash of the sources of that sample: equal versions give equal results. Throws
/// std::invalid_argument for a name that is none of them.
std::string closed_form_version(const std::string& name);

}  // namespace flowslide
