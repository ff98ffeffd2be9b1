// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

// Values from the build system. build_information.cmake updates the file "record/build_values.hpp" on each build. Code
// compiled without CMake has "unknown" everywhere.
#if __has_include("record/build_values.hpp")
#include "record/build_values.hpp"
#else
namespace flowslide::build_information {
inline constexpr const char *code_version = "unknown", *git_revision = "unknown", *git_state = "unknown",
                            *compiler = "unknown", *compiler_flags = "unknown", *build_type = "unknown",
                            *paper_doi = "unknown";
}
#endif
