// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sealed_file.hpp"

#include <gtest/gtest.h>

#include "damage.hpp"
#include "record/hash.hpp"
#include "temporary_folder.hpp"

namespace flowslide {
namespace {

TEST(SealedFile, GivesBackItsContent) {
  const TemporaryFolder folder;
  const std::string content("any\0bytes", 9);
  write_sealed(folder / "file", content, IfExists::refuse);
  EXPECT_EQ(read_sealed(folder / "file", "delete it"), content);
  EXPECT_EQ(read_file(folder / "file").size(), content.size() + seal_size);
  EXPECT_EQ(read_file(folder / "file"), content + "\nflowslide xxh3 " + hash_of(content) + "\n");
  write_sealed(folder / "empty", "", IfExists::refuse);
  EXPECT_EQ(read_sealed(folder / "empty", "delete it"), "");
}

TEST(SealedFile, FindsEveryDamage) {
  const TemporaryFolder folder;
  write_sealed(folder / "file", std::string(1000, 'x'), IfExists::refuse);
  expect_damage_found(folder / "file", [&] { read_sealed(folder / "file", "delete it"); });
}

TEST(SealedFile, SaysHowToMend) {
  const TemporaryFolder folder;
  write_atomically(folder / "file", "something else");
  try {
    read_sealed(folder / "file", "delete it and continue");
    FAIL();
  } catch (const CorruptFileError& error) {
    EXPECT_TRUE(std::string(error.what()).ends_with("delete it and continue")) << error.what();
  }
}

}  // namespace
}  // namespace flowslide
