// SPDX-License-Identifier: GPL-2.0-or-later
#include "sample/closed_form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "dem/source_hashes.hpp"

namespace flowslide {

std::vector<std::string> closed_form_sample_names() { return {"elastic", "critical_state"}; }

bool is_closed_form(const std::string& name) {
  const std::vector<std::string> names = closed_form_sample_names();
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string closed_form_version(const std::string& name) {
  const auto version = [](const char* hash) { return fmt::format("{} ({})", source_hashes::version, hash); };
  if (name == "elastic") return version(source_hashes::elastic);
  if (name == "critical_state") return version(source_hashes::critical_state);
  throw std::invalid_argument("\"" + name + "\" is no closed-form sample; there are elastic and critical_state");
}

}  // namespace flowslide
