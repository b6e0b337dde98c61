#include "presets/printable.h"

#include <gtest/gtest.h>

#include <string>

#include "presets/error.h"

namespace crest::test {
namespace {

TEST(Printable, KeepsWhatPeopleWrite) {
  for (const char* text : {"", "plain", "Größe 5 µm", "日本", "\U0001F980"}) EXPECT_EQ(printable(text), text);
}

TEST(Printable, WritesOutWhatATerminalObeys) {
  EXPECT_EQ(printable("a\nb\tc\r"), "a b c ");
  EXPECT_EQ(printable("\x1b[2J\x07\x7f"), "\\x1b[2J\\x07\\x7f");
  EXPECT_EQ(printable("\u009b31m"), "\\xc2\\x9b31m");
  EXPECT_EQ(printable("a\u202eb"), "a\\xe2\\x80\\xaeb");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
}

TEST(Printable, WritesOutWhatIsNoUtf8) {
  EXPECT_EQ(printable("\xff"
                      "a"),
            "\\xffa");
  EXPECT_EQ(printable("\xc3"), "\\xc3");                             // cut
  EXPECT_EQ(printable("\xc0\xaf"), "\\xc0\\xaf");                    // longer than need be
  EXPECT_EQ(printable("\xe0\x80\xaf"), "\\xe0\\x80\\xaf");           // the same
  EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");           // a surrogate
  EXPECT_EQ(printable("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");  // beyond Unicode
}

// what() ends at a NUL, and messages quote what is in files.
TEST(Printable, IsAnErrorsText) { EXPECT_STREQ(Error(std::string("\0a\nb\x1b", 5)).what(), "\\x00a b\\x1b"); }

TEST(Printable, IsCut) {
  for (const std::string_view piece : {"x", "\x01", "\u00e4"}) {
    std::string whole;
    for (int i = 0; i < 1000; ++i) whole += piece;
    for (const std::size_t longest : {98, 99, 100, 101, 102}) {
      const std::string text = printable(whole, longest);
      EXPECT_LE(text.size(), longest);
      EXPECT_GT(text.size(), longest - 8);
      EXPECT_TRUE(text.ends_with("..."));
      EXPECT_EQ(printable(text, longest), text);
    }
  }
  EXPECT_EQ(printable("abcd", 4), "abcd");
  EXPECT_EQ(printable("abcde", 4), "a...");
}

}  // namespace
}  // namespace crest::test
