// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include "record/atomic_file.hpp"

namespace flowslide {

inline void overwrite(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
}

/// The file cut off at its start, its end and many places between, then with one bit flipped at 200 random places.
inline std::vector<std::string> damaged(const std::string& whole) {
  std::vector<std::string> variants;
  for (std::size_t i = 0; i < 100; ++i) variants.push_back(whole.substr(0, whole.size() * i / 100));
  for (std::size_t cut = 1; cut <= std::min<std::size_t>(100, whole.size()); ++cut)
    variants.push_back(whole.substr(0, whole.size() - cut));
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    std::string flipped = whole;
    flipped[random() % flipped.size()] ^= static_cast<char>(1 << random() % 8);
    variants.push_back(std::move(flipped));
  }
  variants.push_back(whole + "x");
  return variants;
}

/// Expects that `read`, given each damaged form of the file at `path`, throws CorruptFileError that names the file.
template <typename Read>
void expect_damage_found(const std::filesystem::path& path, Read&& read) {
  const std::string whole = read_file(path);
  ASSERT_NO_THROW(read());
  for (const std::string& bytes : damaged(whole)) {
    overwrite(path, bytes);
    try {
      read();
      ADD_FAILURE() << "damage not found, size " << bytes.size() << " of " << whole.size();
    } catch (const CorruptFileError& error) {
      EXPECT_NE(std::string(error.what()).find(path.string()), std::string::npos) << error.what();
    }
  }
  overwrite(path, whole);
  EXPECT_NO_THROW(read());
}

}  // namespace flowslide
