// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/read_finite.hpp"

#include <fmt/format.h>

#include <cmath>

#include "record/assembly_group.hpp"

namespace flowslide {
namespace {

void check_finite(const Assembly& assembly, const std::string& label) {
  const auto require = [&](bool good, const char* name) {
    if (!good) throw CorruptFileError(fmt::format("{}: {}", label, name));
  };
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    require(std::isfinite(assembly.radius[i]) && assembly.radius[i] > 0.0, "a radius that is not positive");
    for (const auto* array :
         {&assembly.position, &assembly.velocity, &assembly.spin, &assembly.force, &assembly.torque})
      require((*array)[i].allFinite(), "a grain that is not finite");
  }
  for (const ContactHistory& contact : assembly.contacts)
    require(contact.tangential_spring.allFinite() && contact.rolling_torque.allFinite(),
            "a contact that is not finite");
  require(assembly.cell.lower.allFinite() && assembly.cell.upper.allFinite() &&
              (assembly.cell.lengths().array() > 0.0).all(),
          "a cell without volume");
}

}  // namespace

void ReadNumber::operator()(const char* name, double& value) const {
  value = group.number_attribute(name);
  if (!std::isfinite(value)) throw CorruptFileError(fmt::format("{}: {} is {}", group.label(), name, value));
}

void ReadNumber::operator()(const char* name, std::int64_t& value) const {
  value = group.integer_attribute(name);
  if (value < 0) throw CorruptFileError(fmt::format("{}: {} is {}", group.label(), name, value));
}

Assembly read_finite_assembly(const hdf5::Group& parent, const std::string& name) {
  Assembly assembly = read_assembly(parent, name);
  check_finite(assembly, parent.label() + "/" + name);
  return assembly;
}

}  // namespace flowslide
