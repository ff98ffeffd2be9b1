// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/read_finite.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

#include "example.hpp"
#include "record/assembly_group.hpp"

namespace flowslide {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();

/// The value that `read` returns for the data that `write` has written.
template <typename Write, typename Read>
auto with(Write&& write, Read&& read) {
  auto file = hdf5::File::create("test");
  hdf5::Group& root = file.root();
  write(root);
  return read(hdf5::File::open(file.image(), "test").root());
}

/// Reads back one number that was written as an attribute.
template <typename Number>
Number number_back(const hdf5::Group& root) {
  Number number{};
  ReadNumber{root}("number", number);
  return number;
}

TEST(ReadFinite, TakesFiniteNumbers) {
  EXPECT_EQ(with([](hdf5::Group& root) { root.set_attribute("number", -0.1); }, number_back<double>), -0.1);
  EXPECT_EQ(with([](hdf5::Group& root) { root.set_attribute("number", std::int64_t{7}); }, number_back<std::int64_t>),
            7);
}

TEST(ReadFinite, RefusesNumbersThatAreNotFiniteAndNegativeCounts) {
  for (const double number : {nan, infinity, -infinity})
    EXPECT_THROW(with([&](hdf5::Group& root) { root.set_attribute("number", number); }, number_back<double>),
                 CorruptFileError);
  EXPECT_THROW(
      with([](hdf5::Group& root) { root.set_attribute("number", std::int64_t{-1}); }, number_back<std::int64_t>),
      CorruptFileError);
}

Assembly grains_back(const hdf5::Group& root) { return read_finite_assembly(root, "grains"); }

TEST(ReadFinite, TakesAnAssemblyAsItWas) {
  const Assembly grains = example_assembly();
  const Assembly back = with([&](hdf5::Group& root) { write_assembly(root, "grains", grains); }, grains_back);
  EXPECT_EQ(back.position, grains.position);
  EXPECT_EQ(back.contacts.size(), grains.contacts.size());
}

TEST(ReadFinite, RefusesGrainsContactsAndCellsThatAreNotFinite) {
  const std::vector<std::function<void(Assembly&)>> faults{
      [](Assembly& a) { a.radius[0] = 0.0; }, [](Assembly& a) { a.radius[0] = nan; },
      [](Assembly& a) { a.position[0].x() = nan; }, [](Assembly& a) { a.torque[0].z() = infinity; },
      [](Assembly& a) { a.contacts.at(0).tangential_spring.y() = nan; },
      [](Assembly& a) { a.contacts.at(0).rolling_torque.y() = nan; },
      [](Assembly& a) { a.cell.upper = a.cell.lower; }, [](Assembly& a) { a.cell.upper.x() = infinity; }};
  for (const auto& fault : faults) {
    Assembly grains = example_assembly();
    fault(grains);
    EXPECT_THROW(with([&](hdf5::Group& root) { write_assembly(root, "grains", grains); }, grains_back),
                 CorruptFileError);
  }
}

TEST(FlawOf, SaysWhatIsWrongAndWhere) {
  Assembly grains = example_assembly();
  EXPECT_EQ(flaw_of(grains), "");
  grains.contacts.at(0).rolling_torque.y() = nan;
  EXPECT_EQ(flaw_of(grains), "the contact of the grains " + std::to_string(grains.contacts[0].first) + " and " +
                                 std::to_string(grains.contacts[0].second) + " is not finite");
  grains.spin[1].x() = infinity;
  EXPECT_EQ(flaw_of(grains), "the spin of grain 1 is not finite");
}

}  // namespace
}  // namespace flowslide
