// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <sstream>
#include <stdexcept>
#include <string>

namespace flowslide {

/// Throws std::invalid_argument unless `allowed`: what is wrong, its value, what is allowed, how to mend it.
inline void require(bool allowed, const std::string& name, double value, const std::string& range,
                    const std::string& mend) {
  if (allowed) return;
  std::ostringstream message;
  message.precision(17);
  message << name << " is " << value << "; allowed: " << range << ". " << mend;
  throw std::invalid_argument(message.str());
}

}  // namespace flowslide
