// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/case_program.hpp"
#include "void_ratio_case.hpp"

int main(int argc, char** argv) {
  flowslide::VoidRatioCase the_case;
  return flowslide::run_case(the_case, argc, argv, FLOWSLIDE_CASE_FOLDER);
}
