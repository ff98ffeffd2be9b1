// SPDX-License-Identifier: GPL-2.0-or-later
#include "configuration/entry_reader.hpp"

#include <sys/stat.h>

#include "configuration/error.hpp"
#include "support/messages.hpp"

namespace flowslide {
namespace {

TEST(ReadEntries, KeepsTheOrderAndThePlacesOfTheText) {
  const auto entries = read_entries("[z]\nb = 1\na = \"3 kPa\"\n[y]\n  c = [1, 2.5]\n", "case.toml");
  ASSERT_EQ(entries.size(), 5U);
  EXPECT_EQ(entries[0].key, "z");
  EXPECT_EQ(entries[1].key, "z.b");
  EXPECT_EQ(entries[2].key, "z.a");
  EXPECT_EQ(entries[2].whole.place.text(), "case.toml:3:5");
  EXPECT_EQ(entries[2].key_place.text(), "case.toml:3:1");
  EXPECT_EQ(entries[2].whole.written, "\"3 kPa\"");
  EXPECT_EQ(entries[4].key, "y.c");
  EXPECT_EQ(entries[4].whole.place.text(), "case.toml:5:7");
  ASSERT_EQ(entries[4].items.size(), 2U);
  EXPECT_EQ(entries[4].items[1].place.text(), "case.toml:5:11");
  EXPECT_EQ(entries[4].items[1].written, "2.5");
}

TEST(ReadEntries, KeepsValuesAsWritten) {
  const auto entries = read_entries("a = 5e-7  # comment\nb = +1_000\nc = 'µ' # é\nd = [\n  1,\n  2 ]\n", "t");
  EXPECT_EQ(entries[0].whole.written, "5e-7");
  EXPECT_EQ(entries[1].whole.written, "+1_000");
  EXPECT_EQ(entries[2].whole.written, "'µ'");
  EXPECT_EQ(entries[3].whole.written, "[ ...");
  EXPECT_EQ(entries[3].items[1].written, "2");
}

TEST(ReadEntries, NumbersTheTablesOfAList) {
  const auto entries = read_entries("[[claim]]\nid = 'a'\n[[claim]]\nid = 'b'\n", "claims.toml");
  ASSERT_EQ(entries.size(), 5U);
  EXPECT_TRUE(entries[0].list_of_tables);
  EXPECT_EQ(entries[1].key, "claim.0");
  EXPECT_FALSE(entries[1].list_of_tables);
  EXPECT_EQ(entries[4].key, "claim.1.id");
  EXPECT_EQ(entries[4].whole.place.text(), "claims.toml:4:6");
}

TEST(ReadEntries, GivesPlaceOfASyntaxError) {
  const std::string message = message_of<ConfigurationError>([] { read_entries("a = 1\nb = = 2\n", "case.toml"); });
  EXPECT_CONTAINS(message, "case.toml:2:5: this is not TOML: ");
  EXPECT_CONTAINS(message_of<ConfigurationError>([] { read_entries("a = 1\na = 2\n", "case.toml"); }), "case.toml:2:");
}

TEST(ReadEntries, SaysThatATextIsNotClosed) {
  const auto complaint = [](const std::string& text) {
    return message_of<ConfigurationError>([&] { read_entries(text, "case.toml"); });
  };
  for (const char* text : {"a = 1\nb = \"3 kPa\nc = 2\n", "a = 1\nb = '3 kPa\nc = 2\n", "a = 1\nb = \"3 kPa\r\n"})
    EXPECT_EQ(complaint(text),
              "case.toml:2:11: this is not TOML: a text is not closed: its second quote is missing in "
              "this line");
  EXPECT_CONTAINS(complaint("b = \"3 kPa"), "a text is not closed: its second quote is missing");
  EXPECT_CONTAINS(complaint("b = '''3 kPa\n"), "a text is not closed: its second quote is missing");
  EXPECT_CONTAINS(complaint("b = \"3\x01 kPa\"\n"), "control characters");
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

TEST(ReadEntries, RefusesWhatIsNestedTooDeeply) {
  const auto complaint = [](const std::string& text) {
    return message_of<ConfigurationError>([&] { read_entries("first = 1\n" + text, "case.toml"); });
  };
  constexpr int deep = 20000;
  const std::string said =
      "is nested too deeply: a key may have 32 parts at most, and 32 brackets at most may be nested";
  EXPECT_EQ(complaint(repeated("a.", deep) + "a = 1\n"), "case.toml:2:64: " + said);
  EXPECT_EQ(complaint("[" + repeated("a.", deep) + "a]\n"), "case.toml:2:65: " + said);
  EXPECT_EQ(complaint("b = " + repeated("[", deep) + repeated("]", deep)), "case.toml:2:37: " + said);
  EXPECT_CONTAINS(complaint("b = " + repeated("{a=", deep) + "1" + repeated("}", deep)), said);
  EXPECT_CONTAINS(complaint("b = " + repeated("{" + repeated("a.", 40) + "a=", 20) + "1" + repeated("}", 20)), said);
  // What is allowed is read, whatever stands within each other.
  const std::string keys = repeated("a.", 30) + "a";
  EXPECT_NO_THROW(read_entries(
      "[" + keys + "]\n" + keys + " = " + repeated("{" + keys + " = ", 30) + "1" + repeated("}", 30), "case.toml"));
}

TEST(ReadEntries, RefusesKeysThatAreNotBare) {
  EXPECT_CONTAINS(message_of<ConfigurationError>([] { read_entries("[s]\n\"a.b\" = 1\n", "case.toml"); }),
                  "case.toml:2:1: the key \"a.b\" is not bare");
}

TEST(ReadEntries, RefusesWhatIsNoUtf8) {
  EXPECT_CONTAINS(message_of<ConfigurationError>([] { read_entries("a = \"\xff\xfe\"\n", "case.toml"); }),
                  "case.toml:1:");
}

TEST(ReadEntries, NamesAFileThatCannotBeRead) {
  const ScratchFolder scratch;
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_entries(scratch.path() / "none.toml"); }),
                  "none.toml: cannot be read");
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_entries(scratch.path()); }), "is a folder");
  EXPECT_TRUE(read_entries(scratch.write("empty.toml", "")).empty());
}

TEST(ReadEntries, TakesAFileWithAByteOrderMarkAndNoPipe) {
  const ScratchFolder scratch;
  const std::vector<Entry> entries = read_entries(scratch.write("marked.toml",
                                                                "\xEF\xBB\xBF"
                                                                "a = 3\n"));
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(entries[0].key, "a");
  EXPECT_EQ(entries[0].key_place.column, 1U);
  const auto pipe = scratch.path() / "pipe.toml";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_entries(pipe); }),
                  "pipe.toml: is a pipe, a socket or a device, but a TOML file is needed");
}

TEST(ReadOption, ReadsAValueAsTomlOrElseAsText) {
  const auto value = [](const std::string& text) {
    return read_option("a", text, "--set a=" + text).back().whole.value;
  };
  EXPECT_EQ(std::get<std::int64_t>(value("3")), 3);
  EXPECT_EQ(std::get<double>(value("3e-2")), 0.03);
  EXPECT_EQ(std::get<bool>(value("true")), true);
  EXPECT_EQ(std::get<std::string>(value("\"3 kPa\"")), "3 kPa");
  EXPECT_EQ(std::get<std::string>(value("3 kPa")), "3 kPa");
  EXPECT_EQ(std::get<std::string>(value("3kPa")), "3kPa");
  EXPECT_EQ(std::get<std::string>(value("")), "");
}

TEST(ReadOption, ReadsLists) {
  const auto entries = read_option("s.a", "[1, 2]", "--set s.a=[1, 2]");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].key, "s");
  EXPECT_EQ(entries[1].key, "s.a");
  EXPECT_EQ(entries[1].items.size(), 2U);
  EXPECT_EQ(entries[1].items[0].place.text(), "--set s.a=[1, 2]");
}

TEST(ReadOption, RefusesAListOrAQuotedTextThatIsNotClosedOrNotQuoted) {
  for (const char* value : {"[0.2 1/s, 0.1 1/s]", "\"3 kPa", " '3 kPa", "[1, 2", "{a = 1"})
    EXPECT_EQ(
        message_of<ConfigurationError>([&] { read_option("a", value, "--set a=..."); }),
        "--set a=...: the value is not TOML: close every quote and bracket, and quote each text of a list, such as "
        "[\"0.2 1/s\", \"0.1 1/s\"]")
        << value;
}

TEST(ReadOption, RefusesWhatIsNestedTooDeeply) {
  constexpr int deep = 20000;
  const auto complaint = [](const std::string& key, const std::string& value) {
    return message_of<ConfigurationError>([&] { read_option(key, value, "--set " + key + "=" + value); });
  };
  EXPECT_CONTAINS(complaint(repeated("a.", deep) + "a", "1"), "--set a.a.a.a");
  EXPECT_CONTAINS(complaint(repeated("a.", deep) + "a", "1"), "...: is nested too deeply");
  EXPECT_LT(complaint(repeated("a.", deep) + "a", "1").size(), 300U);
  EXPECT_CONTAINS(complaint("a", repeated("[", deep) + repeated("]", deep)), "is nested too deeply");
  EXPECT_CONTAINS(complaint("a", "{" + repeated("a.", deep) + "a = 1}"), "is nested too deeply");
}

TEST(ReadOption, CannotSmuggleInASecondKey) {
  const auto entries = read_option("a", "1\nb = 2", "--set");
  ASSERT_EQ(entries.size(), 1U);
  EXPECT_EQ(std::get<std::string>(entries[0].whole.value), "1\nb = 2");
}

TEST(ReadOption, RefusesKeysThatAreNotBare) {
  for (const std::string key : {"", ".", "a.", ".a", "a..b", "a b", "a.\"c\""}) {
    EXPECT_CONTAINS(message_of<ConfigurationError>([&] { read_option(key, "1", "--set"); }), "is not bare") << key;
  }
}

}  // namespace
}  // namespace flowslide
