#include "app/keyboard_layout.h"

#include <gtest/gtest.h>

namespace crest::test {
namespace {

TEST(KeyboardLayout, OnAUsKeyboardEveryKeyIsItself) {
  for (int key = 'A'; key <= 'Z'; ++key) {
    const char name[] = {char(key - 'A' + 'a'), '\0'};
    EXPECT_EQ(key_on_cap(key, name), key);
  }
  for (const char* const name : {"1", "9", "0", ",", "-", "/", ";", "[", "`"})
    EXPECT_EQ(key_on_cap(name[0], name), name[0]);
  EXPECT_EQ(key_on_cap(290, nullptr), 290) << "F1 types nothing";
}

TEST(KeyboardLayout, FrenchLettersAreWhereTheirCapsAre) {
  EXPECT_EQ(key_on_cap('Q', "a"), 'A');
  EXPECT_EQ(key_on_cap('A', "q"), 'Q');
  EXPECT_EQ(key_on_cap('W', "z"), 'Z');
  EXPECT_EQ(key_on_cap(';', "m"), 'M');
  EXPECT_EQ(key_on_cap('M', ","), ',');
}

TEST(KeyboardLayout, FrenchDigitsNeedShiftAndKeepTheirPlace) {
  EXPECT_EQ(key_on_cap('1', "&"), '1');
  EXPECT_EQ(key_on_cap('2', "\u00e9"), '2');
  EXPECT_EQ(key_on_cap('3', "\""), '3');
  EXPECT_EQ(key_on_cap('4', "'"), '4');
}

TEST(KeyboardLayout, GermanAndDvorak) {
  EXPECT_EQ(key_on_cap('Y', "z"), 'Z');
  EXPECT_EQ(key_on_cap('Z', "y"), 'Y');
  EXPECT_EQ(key_on_cap('[', "\u00fc"), '[');
  EXPECT_EQ(key_on_cap(',', "w"), 'W');
  EXPECT_EQ(key_on_cap('Q', "'"), '\'');
}

TEST(KeyboardLayout, WithoutLatinLettersKeysKeepTheirPlace) {
  EXPECT_EQ(key_on_cap('S', "\u044b"), 'S');
  EXPECT_EQ(key_on_cap('Z', "\u03b6"), 'Z');
}

TEST(KeyboardLayout, AnotherSignInTheplaceOfALetterIsNotThatLetter) {
  EXPECT_EQ(key_on_cap('Z', "!"), -1);
  EXPECT_EQ(key_on_cap('/', "!"), '/');
}

}  // namespace
}  // namespace crest::test
