// SPDX-License-Identifier: GPL-2.0-or-later
// The main program of every case. The build links it with case_folder.cpp, compiled for that case, and with the library
// of its folder.
#include "program/case_program.hpp"

namespace flowslide {
extern const char* const case_folder;
}

int main(int argc, char** argv) {
  return flowslide::run_case(*flowslide::make_case(), argc, argv, flowslide::case_folder);
}
