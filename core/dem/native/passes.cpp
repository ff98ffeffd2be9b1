// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/passes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <type_traits>

namespace flowslide::native {

#define FLOWSLIDE_DECLARE_PASSES(set) \
  namespace set {                     \
  Passes<double> double_passes();     \
  Passes<float> float_passes();       \
  }
FLOWSLIDE_DECLARE_PASSES(baseline)
#ifdef FLOWSLIDE_X86
FLOWSLIDE_DECLARE_PASSES(avx2)
FLOWSLIDE_DECLARE_PASSES(avx512)
#endif

namespace {

/// The functions of one instruction set that return its passes.
struct Maker {
  const char* set;
  Passes<double> (*doubles)();
  Passes<float> (*floats)();
};

constexpr Maker makers[] = {
    {"baseline", baseline::double_passes, baseline::float_passes},
#ifdef FLOWSLIDE_X86
    {"avx2", avx2::double_passes, avx2::float_passes},
    {"avx512", avx512::double_passes, avx512::float_passes},
#endif
};

}  // namespace

std::vector<std::string> instruction_sets() {
  std::vector<std::string> sets{"baseline"};
#ifdef FLOWSLIDE_X86
  // The features that -march=x86-64-v3 and -v4 may use.
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512cd");
  if (v3) sets.push_back("avx2");
  if (v4) sets.push_back("avx512");
#endif
  return sets;
}

template <typename Real>
Passes<Real> passes(const std::string& instruction_set) {
  const std::vector<std::string> here = instruction_sets();
  for (const Maker& maker : makers) {
    if (maker.set != instruction_set) continue;
    if (std::find(here.begin(), here.end(), instruction_set) == here.end()) continue;
    if constexpr (std::is_same_v<Real, double>)
      return maker.doubles();
    else
      return maker.floats();
  }
  throw std::invalid_argument(
      fmt::format("there is no instruction set '{}' here; choose one of: {}", instruction_set, fmt::join(here, ", ")));
}

template Passes<double> passes<double>(const std::string&);
template Passes<float> passes<float>(const std::string&);

}  // namespace flowslide::native
