// SPDX-License-Identifier: GPL-2.0-or-later
#include "convergence_case.hpp"
#include "program/case_program.hpp"

int main(int argc, char** argv) {
  flowslide::ConvergenceCase the_case;
  return flowslide::run_case(the_case, argc, argv, FLOWSLIDE_CASE_FOLDER);
}
