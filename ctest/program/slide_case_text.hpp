// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "record/atomic_file.hpp"

namespace flowslide {

/// A configuration of two slides on 150 grains, or on a closed-form sample.
inline std::string slide_case_text() { return read_file(FLOWSLIDE_SOURCE_DIR "/ctest/support/slide_case.toml"); }

}  // namespace flowslide
