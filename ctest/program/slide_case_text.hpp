// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>

#include "record/atomic_file.hpp"

namespace flowslide {

/// A configuration of two slides on 150 grains, or on a closed-form sample.
inline std::string slide_case_text() { return read_file(FLOWSLIDE_SOURCE_DIR "/ctest/support/slide_case.toml"); }

/// The same with an element test up to `final_strain`, the point "alone", and with the scale "quick".
inline std::string slide_and_test_text(const std::string& final_strain = "1e-3") {
  return slide_case_text() + "[point.alone]\nfigures = \"12\"\nsample = \"loose\"\nshear_rate = \"5 1/s\"\n" +
         "final_strain = " + final_strain + "\n[shear_test]\nrows = 10\n[scale.quick]\n";
}

}  // namespace flowslide
