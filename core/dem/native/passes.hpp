// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/motion_pass.hpp"

namespace flowslide::native {

/// The loops over pairs and grains, compiled for one instruction set. All sets give the same bits.
template <typename Real>
struct Passes {
  ContactPass<Real> contacts;
  MotionPass<Real> motion;
  SlackPass<Real> slack;
  MomentPass<Real> moments;
};

/// Instruction sets of this build that the processor supports, from the narrowest, "baseline", to the widest.
std::vector<std::string> instruction_sets();

/// The passes for one of these instruction sets. Throws std::invalid_argument for another name. `Real` is double or
/// float.
template <typename Real>
Passes<Real> passes(const std::string& instruction_set);

}  // namespace flowslide::native
