// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact pass: tiles of contacts, three short loops each (gather, law, scatter), and the motion pass. Compiled
// once per instruction set (see core/CMakeLists.txt) into a namespace of its own, so that no function for wide vectors
// is ever linked elsewhere.
#include "dem/native/isa/gather_scatter.hpp"
#include "dem/native/isa/integrate.hpp"
#include "dem/native/isa/law.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {
namespace {

template <bool Sliding, bool Rolling, bool Virial>
void all_pairs(const LawConstants& constants, const PairView& pairs, const Body* bodies, Load* loads, double* virial) {
  Tile tile;
  for (std::size_t start = 0; start < pairs.count; start += Tile::size) {
    gather<Sliding, Rolling>(pairs, start, bodies, tile);
    apply_law<Sliding, Rolling>(constants, tile);
    scatter<Sliding, Rolling>(pairs, start, tile, loads);
    if constexpr (Virial) add_virial(tile, virial);
  }
}

template <bool Sliding, bool Rolling>
void either(const LawConstants& constants, const PairView& pairs, const Body* bodies, Load* loads, double* virial) {
  if (virial)
    all_pairs<Sliding, Rolling, true>(constants, pairs, bodies, loads, virial);
  else
    all_pairs<Sliding, Rolling, false>(constants, pairs, bodies, loads, virial);
}

}  // namespace

void pass(LawVariant variant, const LawConstants& constants, const PairView& pairs, const Body* bodies, Load* loads,
          double* virial) {
  switch (variant) {
    case LawVariant::frictionless: return either<false, false>(constants, pairs, bodies, loads, virial);
    case LawVariant::sliding: return either<true, false>(constants, pairs, bodies, loads, virial);
    case LawVariant::sliding_and_rolling: return either<true, true>(constants, pairs, bodies, loads, virial);
  }
}

double motion(MotionPart part, std::size_t count, double time_step, const double* kick, const double* twist,
              const MeanFlow& flow, Body* bodies, Load* loads) {
  switch (part) {
    case MotionPart::end: return integrate<true, false>(count, time_step, kick, twist, flow, bodies, loads);
    case MotionPart::begin: return integrate<false, true>(count, time_step, kick, twist, flow, bodies, loads);
    case MotionPart::end_and_begin: return integrate<true, true>(count, time_step, kick, twist, flow, bodies, loads);
  }
  return 0.0;
}

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
