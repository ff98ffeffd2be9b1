// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "grains/assembly.hpp"
#include "record/series.hpp"

namespace flowslide {

template <typename T>
void expect_same_bits(const std::vector<T>& left, const std::vector<T>& right, const char* name) {
  ASSERT_EQ(left.size(), right.size()) << name;
  if (left.empty()) return;
  EXPECT_EQ(std::memcmp(left.data(), right.data(), left.size() * sizeof(T)), 0) << name;
}

inline void expect_same_bits(const Column& left, const Column& right) {
  EXPECT_EQ(left.name, right.name);
  EXPECT_EQ(left.symbol, right.symbol);
  EXPECT_EQ(left.units, right.units);
  EXPECT_EQ(left.long_name, right.long_name);
  EXPECT_EQ(left.sign_convention, right.sign_convention);
  expect_same_bits(left.values, right.values, left.name.c_str());
}

inline void expect_same_bits(const Series& left, const Series& right) {
  expect_same_bits(left.axis, right.axis);
  ASSERT_EQ(left.columns.size(), right.columns.size());
  for (std::size_t i = 0; i < left.columns.size(); ++i) expect_same_bits(left.columns[i], right.columns[i]);
}

inline void expect_same_bits(const Assembly& left, const Assembly& right) {
  EXPECT_EQ(left.cell.lower, right.cell.lower);
  EXPECT_EQ(left.cell.upper, right.cell.upper);
  EXPECT_EQ(left.cell.periodic, right.cell.periodic);
  EXPECT_EQ(left.cell.shear_offset, right.cell.shear_offset);
  EXPECT_EQ(left.cell.shear_velocity, right.cell.shear_velocity);
  expect_same_bits(left.radius, right.radius, "radius");
  expect_same_bits(left.position, right.position, "position");
  expect_same_bits(left.velocity, right.velocity, "velocity");
  expect_same_bits(left.spin, right.spin, "spin");
  expect_same_bits(left.force, right.force, "force");
  expect_same_bits(left.torque, right.torque, "torque");
  expect_same_bits(left.role, right.role, "role");
  expect_same_bits(left.contacts, right.contacts, "contacts");
}

}  // namespace flowslide
