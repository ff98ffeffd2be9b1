// SPDX-License-Identifier: GPL-2.0-or-later
#include "program/versions.hpp"

#include "dem/make_engine.hpp"
#include "dem/source_hashes.hpp"
#include "sample/closed_form.hpp"
#include "sample/void_ratio_search.hpp"
#include "sample_library/sample_cache.hpp"

namespace flowslide {

std::string engine_version(const std::string& name) {
  return is_closed_form(name) ? closed_form_version(name) : make_engine(name, "/dev/null")->version();
}

RunVersions versions_of(const RunInputs& inputs) {
  RunVersions versions;
  versions.run = source_hashes::run;
  if (!inputs.engine.empty()) versions.engine = engine_version(inputs.engine);
  if (const std::string& name = inputs.preparation_engine; !name.empty()) {
    versions.preparation = preparation_identity(name, engine_version(name));
    versions.search = search_version();
  }
  return versions;
}

}  // namespace flowslide
