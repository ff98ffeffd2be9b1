// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <locale.h>
#include <stdlib.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <locale>
#include <stdexcept>
#include <string>
#include <string_view>

namespace flowslide {

/// While one lives, the process has a locale with a decimal comma and points between thousands, as a host program may
/// have set it: for the C library and for C++ streams. No installed locale is needed: the file that `localedef` makes
/// of
///   LC_NUMERIC
///   decimal_point ","
///   thousands_sep "."
///   grouping 3;3
///   END LC_NUMERIC
/// is 54 bytes long and written here.
class CommaLocale {
 public:
  CommaLocale() {
    using namespace std::string_view_literals;
    constexpr std::string_view numeric =
        "\x14\x11\x03\x20\x06\0\0\0\x20\0\0\0\x22\0\0\0\x24\0\0\0\x28\0\0\0\x2c\0\0\0\x30\0\0\0"
        ",\0.\0\x03\x03\0\0,\0\0\0.\0\0\0UTF-8\0"sv;
    std::string folder = (std::filesystem::temp_directory_path() / "flowslide_locale_XXXXXX").string();
    if (::mkdtemp(folder.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = folder;
    std::filesystem::create_directory(folder_ / "comma");
    std::ofstream(folder_ / "comma" / "LC_NUMERIC", std::ios::binary) << numeric;
    ::setenv("LOCPATH", folder_.c_str(), 1);
    works_ = ::setlocale(LC_NUMERIC, "comma") != nullptr;
    std::locale::global(std::locale(std::locale::classic(), new Comma));
  }
  ~CommaLocale() {
    std::locale::global(std::locale::classic());
    ::setlocale(LC_NUMERIC, "C");
    ::unsetenv("LOCPATH");
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  CommaLocale(const CommaLocale&) = delete;
  CommaLocale& operator=(const CommaLocale&) = delete;

  /// Whether the C library has taken it; one of another kind may not.
  bool works() const { return works_; }

 private:
  class Comma : public std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  std::filesystem::path folder_;
  bool works_ = false;
};

}  // namespace flowslide
