// SPDX-License-Identifier: GPL-2.0-or-later
#include "dem/liggghts/c_locale.hpp"

namespace flowslide {
namespace {

locale_t locale_of_c() {
  static const locale_t locale = ::newlocale(LC_ALL_MASK, "C", nullptr);
  return locale;
}

}  // namespace

CLocale::CLocale() : before_(::uselocale(locale_of_c())) {}

CLocale::~CLocale() { ::uselocale(before_); }

}  // namespace flowslide
