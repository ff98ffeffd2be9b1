// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/contact_pass.hpp"

#include <cstring>
#include <initializer_list>

namespace flowslide::native {

#define FLOWSLIDE_DECLARE_PASS(set)                                                                              \
  namespace set {                                                                                                \
  void pass(LawVariant, const LawConstants&, const PairView&, const Body*, Load*, double*);                      \
  double motion(MotionPart, std::size_t, double, const double*, const double*, const MeanFlow&, Body*, Load*);   \
  }
FLOWSLIDE_DECLARE_PASS(baseline)
#ifdef FLOWSLIDE_X86
FLOWSLIDE_DECLARE_PASS(avx2)
FLOWSLIDE_DECLARE_PASS(avx512)
#endif

namespace {

struct Passes {
  ContactPass contacts = nullptr;
  MotionPass motion = nullptr;
};

Passes passes(const char* instruction_set) {
  if (std::strcmp(instruction_set, "baseline") == 0) return {baseline::pass, baseline::motion};
#ifdef FLOWSLIDE_X86
  // What -march=x86-64-v3 and -v4 may use.
  const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2");
  const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
                  __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512vl") &&
                  __builtin_cpu_supports("avx512cd");
  if (std::strcmp(instruction_set, "avx2") == 0 && v3) return {avx2::pass, avx2::motion};
  if (std::strcmp(instruction_set, "avx512") == 0 && v4) return {avx512::pass, avx512::motion};
#endif
  return {};
}

Passes widest_passes() {
  for (const char* set : {"avx512", "avx2"})
    if (const Passes widest = passes(set); widest.contacts) return widest;
  return passes("baseline");
}

}  // namespace

ContactPass contact_pass(const char* instruction_set) { return passes(instruction_set).contacts; }
ContactPass contact_pass() { return widest_passes().contacts; }
MotionPass motion_pass(const char* instruction_set) { return passes(instruction_set).motion; }
MotionPass motion_pass() { return widest_passes().motion; }

}  // namespace flowslide::native
