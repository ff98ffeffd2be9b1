// SPDX-License-Identifier: GPL-2.0-or-later
// The main program of every case: the build compiles it once for each, beside the library of its folder.
#include "program/case_program.hpp"

int main(int argc, char** argv) {
  return flowslide::run_case(*flowslide::make_case(), argc, argv, FLOWSLIDE_CASE_FOLDER);
}
