// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <locale.h>

namespace flowslide {

/// While an object of this class exists, this thread uses the locale "C" in the C library. Other threads keep their
/// locale. Reason: LIGGGHTS reads its commands with atof, which reads "0.5" as 0 in a locale with a decimal comma.
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
