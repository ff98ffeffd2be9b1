// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/assembly_group.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "example.hpp"
#include "same_bits.hpp"

namespace flowslide {
namespace {

Assembly read_again(const Assembly& assembly) {
  auto file = hdf5::File::create("test");
  write_assembly(file.root(), "assembly", assembly);
  return read_assembly(hdf5::File::open(file.image(), "test").root(), "assembly");
}

TEST(AssemblyGroup, GivesBackEveryBit) {
  auto assembly = example_assembly();
  assembly.velocity[0].x() = -0.0;
  assembly.velocity[1].x() = 5e-324;
  expect_same_bits(read_again(assembly), assembly);
}

TEST(AssemblyGroup, GivesBackAShearedCell) {
  Assembly sheared = example_assembly(4);
  sheared.cell.periodic = {true, true, true};
  sheared.cell.shear_offset = 0.0123;
  sheared.cell.shear_velocity = -4.5;
  expect_same_bits(read_again(sheared), sheared);
}

TEST(AssemblyGroup, TakesAnEmptyAssembly) {
  expect_same_bits(read_again(example_assembly(0)), example_assembly(0));
  expect_same_bits(read_again(example_assembly(1)), example_assembly(1));
}

TEST(AssemblyGroup, ArraysHaveShapesAndUnits) {
  auto file = hdf5::File::create("test");
  write_assembly(file.root(), "assembly", example_assembly(40));
  const auto group = file.root().group("assembly");
  EXPECT_EQ(group.dataset("radius").shape(), hdf5::Shape{40});
  EXPECT_EQ(group.dataset("position").shape(), (hdf5::Shape{40, 3}));
  EXPECT_EQ(group.dataset("contact_pair").shape(), (hdf5::Shape{76, 2}));
  EXPECT_EQ(group.dataset("contact_tangential_spring").shape(), (hdf5::Shape{76, 3}));
  EXPECT_EQ(group.read<double>("position", {40, 3})[5], example_assembly().position[1].z());
  EXPECT_EQ(group.dataset("spin").text_attribute("units"), "rad/s");
  for (const auto& name : group.names()) EXPECT_NO_THROW(group.dataset(name).text_attribute("units")) << name;
}

TEST(AssemblyGroup, RefusesAnImpossibleAssembly) {
  const std::vector<std::function<void(Assembly&)>> mistakes{
      [](Assembly& assembly) { assembly.role[3] = static_cast<Role>(3); },
      [](Assembly& assembly) { assembly.contacts[3].second = 40; },
      [](Assembly& assembly) { std::swap(assembly.contacts[3].first, assembly.contacts[3].second); },
      [](Assembly& assembly) { std::swap(assembly.contacts[3], assembly.contacts[4]); },
      [](Assembly& assembly) { assembly.contacts[3] = assembly.contacts[4]; }};
  for (const auto& mistake : mistakes) {
    auto assembly = example_assembly(40);
    mistake(assembly);
    EXPECT_THROW(read_again(assembly), CorruptFileError);
  }
  auto uneven = example_assembly(40);
  uneven.spin.pop_back();
  EXPECT_THROW(read_again(uneven), std::invalid_argument);
}

}  // namespace
}  // namespace flowslide
