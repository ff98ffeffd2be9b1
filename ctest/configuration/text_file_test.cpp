// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/text_file.hpp"

#include <sys/stat.h>

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

class TextFile : public testing::Test {
 protected:
  std::string read(const std::string& bytes) const { return read_text_file(folder_.write("text", bytes), "a text"); }
  std::string complaint(const std::filesystem::path& file) const {
    return message_of<ConfigurationError>([&] { read_text_file(file, "a text"); });
  }
  ScratchFolder folder_;
};

TEST_F(TextFile, IsReadByteByByteButForItsMark) {
  EXPECT_EQ(read(""), "");
  EXPECT_EQ(read("a\r\n\0b"), "a\r\n\0b");
  EXPECT_EQ(read("\xEF\xBB\xBF"
                 "0 0\n"),
            "0 0\n");
  EXPECT_EQ(read("0 \xEF\xBB\xBF"), "0 \xEF\xBB\xBF");  // no mark: it does not begin the text
}

TEST_F(TextFile, OfAnotherEncodingIsRefused) {
  using namespace std::string_literals;
  for (const std::string& bytes : {"\xFF\xFE"
                                   "0\0"s,
                                   "\xFE\xFF\0"
                                   "0"s,
                                   "\xFF\xFE\0\0"
                                   "0\0\0\0"s,
                                   "\0\0\xFE\xFF\0\0\0"
                                   "0"s})
    EXPECT_CONTAINS(complaint(folder_.write("wide", bytes)), "wide: is UTF-16 or UTF-32; save it as UTF-8");
}

TEST_F(TextFile, ThatIsNoRegularFileIsRefusedAtOnce) {
  EXPECT_CONTAINS(complaint(folder_.path()), ": is a folder, but a text is needed; give the path of the file");
  const auto pipe = folder_.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);  // no one writes to it: reading would wait for ever
  EXPECT_CONTAINS(complaint(pipe), "pipe: is a pipe, a socket or a device, but a text is needed");
  EXPECT_CONTAINS(complaint("/dev/zero"), "/dev/zero: is a pipe, a socket or a device");
}

TEST_F(TextFile, ThatIsMissingIsNamed) {
  EXPECT_CONTAINS(complaint(folder_.path() / "none"), "none: cannot be read; check the path and its permissions");
  std::filesystem::create_symlink(folder_.path() / "none", folder_.path() / "link");
  EXPECT_CONTAINS(complaint(folder_.path() / "link"), "link: cannot be read");
}

}  // namespace
}  // namespace flowslide
