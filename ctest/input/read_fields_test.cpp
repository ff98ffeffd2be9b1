// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/read_fields.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide::read_fields_test {
namespace {

struct Settings {
  double length = 0.0;
  double ratio = 0.0;
  int count = 0;
  std::int64_t steps = 0;
  bool on = false;
  std::array<double, 3> rates{};
  std::array<int, 3> lattice{};
  std::uint64_t seed = 0;
  static constexpr auto fields() {
    return std::tuple{Field{"length", &Settings::length, "m", Bounds::positive()},
                      Field{"ratio", &Settings::ratio, "1", Bounds::between(0, 1)},
                      Field{"count", &Settings::count, "1", Bounds::between(1, 9)},
                      Field{"steps", &Settings::steps},
                      Field{"on", &Settings::on},
                      Field{"rates", &Settings::rates, "1/s", Bounds::positive()},
                      Field{"lattice", &Settings::lattice, "1", Bounds::at_least(3)},
                      Field{"seed", &Settings::seed}};
  }
};
static_assert(lists_every_member<Settings>());

constexpr const char* text = R"([settings]
length = "2 mm"
ratio = "25 %"
count = 4
steps = 5
on = true
rates = ["1 1/s", "2 1/s", "60 1/min"]
lattice = [3, 4, 5]
)";

Settings read(const std::string& from = "", const std::string& to = "") {
  std::string changed = text;
  changed.replace(changed.find(from), from.size(), to);
  const Configuration configuration = Configuration::from_text(changed, "case.toml");
  Settings settings;
  read_fields(Tables(configuration, "settings"), settings, {"seed"});
  configuration.reject_unknown();
  return settings;
}

TEST(ReadFields, TakesEachFieldInItsUnit) {
  const Settings settings = read();
  EXPECT_EQ(settings.length, 2e-3);
  EXPECT_EQ(settings.ratio, 0.25);
  EXPECT_EQ(settings.count, 4);
  EXPECT_EQ(settings.steps, 5);
  EXPECT_TRUE(settings.on);
  EXPECT_EQ(settings.rates, (std::array{1.0, 2.0, 1.0}));
  EXPECT_EQ(settings.lattice, (std::array{3, 4, 5}));
  EXPECT_EQ(settings.seed, 0u);  // elsewhere
}

TEST(ReadFields, RefusesWhatTheFieldDoesNotAllow) {
  const auto complaint = [](const std::string& from, const std::string& to) {
    return message_of<ConfigurationError>([&] { read(from, to); });
  };
  EXPECT_CONTAINS(complaint("2 mm", "0 mm"), "case.toml:2:10: settings.length");
  EXPECT_CONTAINS(complaint("2 mm", "2 s"), "settings.length");
  EXPECT_CONTAINS(complaint("25 %", "125 %"), "it must be between 0 and 1");
  EXPECT_CONTAINS(complaint("count = 4", "count = 10"), "settings.count = 10");
  EXPECT_CONTAINS(complaint("[3, 4, 5]", "[3, 4]"), "settings.lattice = [3, 4] has 2 values, but 3 are needed");
  EXPECT_CONTAINS(complaint("[3, 4, 5]", "[3, 4, 2]"), "settings.lattice = 2 is not allowed");
  EXPECT_CONTAINS(complaint("on = true\n", ""), "\"settings.on\" is missing");
}

TEST(ReadFields, RefusesANameThatIsNoField) {
  const Configuration configuration = Configuration::from_text(text);
  Settings settings;
  EXPECT_THROW(read_fields(Tables(configuration, "settings"), settings, {"sead"}), std::logic_error);
  EXPECT_THROW(read_fields(Tables(configuration, "settings"), settings), std::logic_error);  // of an unsigned seed
}

TEST(ReadField, TakesOneMember) {
  const Configuration configuration = Configuration::from_text(text);
  Settings settings;
  read_field(Tables(configuration, "settings"), settings, &Settings::ratio);
  EXPECT_EQ(settings.ratio, 0.25);
  EXPECT_EQ(settings.length, 0.0);
  EXPECT_STREQ(key_of(&Settings::length).name, "length");
  EXPECT_EQ(key_of(&Settings::length).dimension(), dimension::length);
  EXPECT_EQ(key_of(&Settings::ratio).dimension(), dimension::dimensionless);
}

}  // namespace
}  // namespace flowslide::read_fields_test
