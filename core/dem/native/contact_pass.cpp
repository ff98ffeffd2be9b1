// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/native/contact_pass.hpp"

#include <cstring>
#include <initializer_list>

namespace flowslide::native {

#define FLOWSLIDE_DECLARE_PASS(set)                                                                              \
  namespace set {                                                                                                \
  void pass(LawVariant, const LawConstants&, const PairView&, const Body*, Load*, double*);                      \
  }
FLOWSLIDE_DECLARE_PASS(baseline)
#ifdef FLOWSLIDE_X86
FLOWSLIDE_DECLARE_PASS(avx2)
FLOWSLIDE_DECLARE_PASS(avx512)
#endif

ContactPass contact_pass(const char* instruction_set) {
  if (std::strcmp(instruction_set, "baseline") == 0) return baseline::pass;
#ifdef FLOWSLIDE_X86
  if (std::strcmp(instruction_set, "avx2") == 0 && __builtin_cpu_supports("avx2")) return avx2::pass;
  if (std::strcmp(instruction_set, "avx512") == 0 && __builtin_cpu_supports("avx512f") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    return avx512::pass;
#endif
  return nullptr;
}

ContactPass contact_pass() {
  for (const char* set : {"avx512", "avx2"})
    if (const ContactPass widest = contact_pass(set)) return widest;
  return contact_pass("baseline");
}

}  // namespace flowslide::native
