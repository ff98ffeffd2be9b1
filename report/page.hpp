// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "report/collection.hpp"

namespace flowslide {

struct PageSetting {
  std::string scale;              ///< name of the scale on the page
  std::string options;            ///< options of ./reproduce, besides figures, that made these results
  std::string style;              ///< CSS
  std::filesystem::path folder;   ///< folder of the page; links to data start there
};

/// The report as one HTML page. It contains pictures, style and script, and needs no network. Throws FileError for a
/// picture or table that cannot be read.
std::string report_page(const std::vector<CaseResults>& cases, const PageSetting& setting);

}  // namespace flowslide
