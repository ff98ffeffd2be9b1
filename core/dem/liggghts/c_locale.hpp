// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <locale.h>

namespace flowslide {

/// While one lives, this thread has the locale "C" for the functions of the C library: LIGGGHTS reads its commands with
/// atof, which takes "0.5" for 0 where a host program has set a locale with a decimal comma. Other threads keep theirs.
class CLocale {
 public:
  CLocale();
  ~CLocale();
  CLocale(const CLocale&) = delete;
  CLocale& operator=(const CLocale&) = delete;

 private:
  locale_t before_;
};

}  // namespace flowslide
