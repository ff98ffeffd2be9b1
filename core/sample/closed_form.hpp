// SPDX-License-Identifier: GPL-2.0-or-later
// Closed-form samples, which replace the DEM where grains do not matter: their names and the versions of their sources.
#pragma once
#include <string>
#include <vector>

namespace flowslide {

/// "elastic" and "critical_state". A configuration gives such a name in place of an engine; the table of the same name
/// holds the properties of the sample.
std::vector<std::string> closed_form_sample_names();
bool is_closed_form(const std::string& name);

/// The version of this project and a hash of the sources of the sample `name`. Equal versions give equal results.
/// Throws std::invalid_argument for an unknown name.
std::string closed_form_version(const std::string& name);

}  // namespace flowslide
