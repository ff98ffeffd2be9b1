// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace flowslide {

/// Any bytes as text (RFC 4648, with padding).
std::string base64(std::string_view bytes);

}  // namespace flowslide
