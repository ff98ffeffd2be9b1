// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

// What the build system knows. The file "record/build_values.hpp" is made anew on each build by
// build_information.cmake; code compiled without CMake knows nothing.
#if __has_include("record/build_values.hpp")
#include "record/build_values.hpp"
#else
namespace flowslide::build_information {
inline constexpr const char *code_version = "unknown", *git_revision = "unknown", *git_state = "unknown",
                            *compiler = "unknown", *compiler_flags = "unknown", *build_type = "unknown",
                            *paper_doi = "unknown";
}
#endif
