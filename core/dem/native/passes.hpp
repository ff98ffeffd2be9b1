// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <vector>

#include "dem/native/contact_pass.hpp"
#include "dem/native/motion_pass.hpp"

namespace flowslide::native {

/// Stands for the bits of this version in portable arithmetic: the hash of a state after 1000 steps that
/// determinism_test finds. Prepared samples are kept under it, so that a change of the bits prepares them anew.
inline constexpr const char* bits_in_double = "6d2bf90813a0e2a9";

/// How sums of products are rounded.
enum class Arithmetic {
  portable,  ///< after each operation: the same bits from every compiler and on every processor
  fused      ///< at the compiler's choice once for a product and a sum, which is faster where the processor can
};

/// The loops over pairs and grains, compiled for one instruction set. In portable arithmetic all sets give the same
/// bits.
template <typename Real>
struct Passes {
  ContactPass<Real> contacts;
  MotionPass<Real> motion;
  SlackPass<Real> slack;
  MomentPass<Real> moments;
};

/// Instruction sets of this build that this processor has, the narrowest, "baseline", first.
std::vector<std::string> instruction_sets();

/// The passes of one of them; throws std::invalid_argument for another name. `Real` is double or float.
template <typename Real>
Passes<Real> passes(const std::string& instruction_set, Arithmetic arithmetic);

}  // namespace flowslide::native
