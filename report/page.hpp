// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/collection.hpp"

namespace flowslide {

struct PageSetting {
  std::string scale;              ///< as it is called on the page
  std::string options;            ///< what ./reproduce was told beside figures, to make these results
  std::string style;              ///< CSS
  std::filesystem::path folder;   ///< where the page will lie; links lead from there to data
};

/// The report as one HTML page that needs no network and no other file: pictures, style and script are in it.
/// Throws FileError for a picture or table that cannot be read.
std::string report_page(const std::vector<CaseResults>& cases, const PageSetting& setting);

}  // namespace flowslide
