// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <string>

#include "dem/native/native_engine.hpp"
#include "support/touching_lattice.hpp"

namespace flowslide {

inline void expect_same_bits(const Assembly& a, const Assembly& b, const std::string& where = {}) {
  ASSERT_EQ(a.size(), b.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    different += a.position[i] != b.position[i] || a.velocity[i] != b.velocity[i] || a.spin[i] != b.spin[i] ||
                 a.force[i] != b.force[i] || a.torque[i] != b.torque[i];
  EXPECT_EQ(different, 0u) << "of " << a.size() << " grains, " << where;
  ASSERT_EQ(a.contacts.size(), b.contacts.size()) << where;
  different = 0;
  for (std::size_t c = 0; c < a.contacts.size(); ++c)
    different += a.contacts[c].first != b.contacts[c].first || a.contacts[c].second != b.contacts[c].second ||
                 a.contacts[c].tangential_spring != b.contacts[c].tangential_spring ||
                 a.contacts[c].rolling_torque != b.contacts[c].rolling_torque;
  EXPECT_EQ(different, 0u) << "of " << a.contacts.size() << " contacts, " << where;
}

inline void expect_same_bits(const CellStress& a, const CellStress& b, const std::string& where = {}) {
  for (auto part : {&CellStress::normal, &CellStress::shear, &CellStress::transverse, &CellStress::lateral_x,
                    &CellStress::lateral_y})
    EXPECT_EQ(a.*part, b.*part) << where;
}

inline void expect_same_bits(const Engine& a, const Engine& b, const std::string& where = {}) {
  expect_same_bits(a.save(), b.save(), where);
  expect_same_bits(a.cell_stress(), b.cell_stress(), where);
  EXPECT_EQ(a.count_grains(), b.count_grains()) << where;
}

/// FNV-1a, 64 bits, of the bytes of numbers.
class Fingerprint {
 public:
  template <typename Number>
  void add(Number number) {
    unsigned char bytes[sizeof number];
    std::memcpy(bytes, &number, sizeof number);
    for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001b3u;
  }
  void add(const Vector3& v) {
    for (int axis = 0; axis < 3; ++axis) add(v[axis]);
  }
  std::uint64_t hash() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325u;
};

/// Expects equal bits of the whole state of two engines, and of their stress.
inline std::uint64_t fingerprint(const Engine& engine) {
  const Assembly a = engine.save();
  const CellStress stress = engine.cell_stress();
  Fingerprint print;
  print.add(a.cell.lower);
  print.add(a.cell.upper);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const auto* array : {&a.position, &a.velocity, &a.spin, &a.force, &a.torque}) print.add((*array)[i]);
    print.add(a.radius[i]);
  }
  for (const ContactHistory& contact : a.contacts) {
    print.add(contact.first);
    print.add(contact.second);
    print.add(contact.tangential_spring);
    print.add(contact.rolling_torque);
  }
  for (const double part : {stress.normal, stress.shear, stress.transverse, stress.lateral_x, stress.lateral_y})
    print.add(part);
  return print.hash();
}

}  // namespace flowslide
