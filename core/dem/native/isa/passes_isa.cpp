// SPDX-License-Identifier: GPL-2.0-or-later
//
// The contact pass, in tiles of contacts with three short loops each (gather, law, scatter), and the passes over
// grains. This file is compiled once per instruction set (see core/CMakeLists.txt), each time into a separate
// namespace. No function for wide vectors can thus be linked into other code.
#include "dem/native/isa/gather.hpp"
#include "dem/native/isa/law.hpp"
#include "dem/native/isa/motion.hpp"
#include "dem/native/isa/scatter.hpp"
#include "dem/native/passes.hpp"

namespace flowslide::native {
inline namespace FLOWSLIDE_ISA {
namespace {

/// Starts to fetch the second grains of a tile. In the order of the list, a grain is read for the first time as the
/// second of a pair, at a place that no hardware foresees.
template <typename Real>
inline void fetch_second(const std::uint32_t* second, const Body<Real>* bodies, Load<Real>* loads) {
  constexpr std::size_t line = 64;
  for (int k = 0; k < tile_size; ++k) {
    const char* body = reinterpret_cast<const char*>(bodies + second[k]);
    for (std::size_t at = 0; at < sizeof(Body<Real>); at += line) __builtin_prefetch(body + at);
    __builtin_prefetch(loads + second[k], 1);
  }
}

template <typename Real, typename Law, bool Sliding, bool Rolling>
void all_pairs(const LawConstants<Real>& constants, const PairView<Real>& pairs, const Body<Real>* bodies,
               Load<Real>* loads, AcrossFaces* across) {
  constexpr bool spins = Sliding || Rolling;
  Tile<Real> tile;
  for (std::size_t start = pairs.begin; start < pairs.end; start += Tile<Real>::size) {
    if (start + fetch_distance < pairs.fetch_end)
      fetch_second(pairs.second + start + fetch_distance, bodies, loads);
    gather<Real, typename Law::Normal, spins>(pairs, start, bodies, tile);
    apply_law<Real, Law, Sliding, Rolling>(constants, tile);
    scatter<Real, spins>(pairs, start, tile, loads);
    if (across) add_across(pairs, start, tile, across);
  }
}

template <typename Real>
void contacts(const LawConstants<Real>& constants, const PairView<Real>& pairs,
              const Body<Real>* bodies, Load<Real>* loads, AcrossFaces* across) {
  visit_law(constants.law, [&]<typename Law>(Law) {
    switch (constants.variant) {
      case LawVariant::frictionless: return all_pairs<Real, Law, false, false>(constants, pairs, bodies, loads, across);
      case LawVariant::sliding: return all_pairs<Real, Law, true, false>(constants, pairs, bodies, loads, across);
      case LawVariant::sliding_and_rolling:
        return all_pairs<Real, Law, true, true>(constants, pairs, bodies, loads, across);
    }
  });
}

template <typename Real>
MotionExtremes motion(MotionPart part, double time_step, const MeanFlow& flow, const Box& box,
                      const MovingGrains<Real>& grains) {
  switch (part) {
    case MotionPart::end: return move<Real, true, false>(time_step, flow, box, grains);
    case MotionPart::begin: return move<Real, false, true>(time_step, flow, box, grains);
    case MotionPart::end_and_begin: return move<Real, true, true>(time_step, flow, box, grains);
  }
  return {};
}

}  // namespace

Passes<double> double_passes() { return {contacts<double>, motion<double>, slack<double>, moments<double>}; }
Passes<float> float_passes() { return {contacts<float>, motion<float>, slack<float>, moments<float>}; }

}  // namespace FLOWSLIDE_ISA
}  // namespace flowslide::native
