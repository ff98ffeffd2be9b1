// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/hash.hpp"

#include <gtest/gtest.h>

namespace flowslide {
namespace {

TEST(Hash, IsThatOfTheCommandXxhsum) {  // printf '' | xxhsum -H128, and so on
  EXPECT_EQ(hash_of(""), "99aa06d3014798d86001c324468d497f");
  EXPECT_EQ(hash_of("abc"), "06b05ab6733a618578af5f94892f3950");
}

TEST(Hash, ChangesWithEveryByteAndLength) {
  const std::string text(1000, 'x');
  for (std::size_t i = 0; i < text.size(); i += 37) {
    std::string changed = text;
    changed[i] ^= 1;
    EXPECT_NE(hash_of(changed), hash_of(text));
    EXPECT_NE(hash_of(text.substr(0, i)), hash_of(text));
  }
}

}  // namespace
}  // namespace flowslide
