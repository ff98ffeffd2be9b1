// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/collection.hpp"

namespace flowslide {

/// The provenance of runs as an HTML table, with links from `folder` to their files.
std::string runs_table(const std::vector<Run>& runs, const std::filesystem::path& folder);

}  // namespace flowslide
