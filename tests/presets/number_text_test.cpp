#include "presets/number_text.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crest {
namespace {

TEST(ReadNumber, AsPeopleWriteThem) {
  const std::pair<const char*, double> cases[] = {
      {"0.5", 0.5},         {".5", 0.5},      {"0,5", 0.5},    {"-,25", -0.25},  {"1/2", 0.5},
      {" 1 / 3 ", 1.0 / 3}, {"1e-4", 1e-4},   {"+7", 7},       {"-3", -3},       {"5.", 5},
      {"1E3", 1e3},         {"0,125", 0.125}, {"1,5/2", 0.75}, {"12,34", 12.34}, {"1,0005", 1.0005},
      {"1/-4", -0.25}};
  for (const auto& [text, number] : cases) {
    const TypedNumber typed = read_number(text);
    ASSERT_TRUE(typed.number) << text << ": " << typed.wrong;
    EXPECT_EQ(*typed.number, number) << text;
  }
}

TEST(ReadNumber, RefusesTheRestInWords) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "is not a number"},       {"abc", "is not a number"},      {"1 2", "is not a number"},
      {"nan", "is not a number"},    {"inf", "is not a number"},      {"1e999", "beyond"},
      {"1e-999", "beyond"},          {"1/0", "divides by zero"},      {"1/2/3", "fraction"},
      {"1,000", "read in two ways"}, {"-12,345", "read in two ways"}, {"1,2,3", "more than one"},
      {"1,234.5", "more than one"},  {"1.234,5", "more than one"},    {"0x10", "is not a number"},
      {"1e300/1e-300", "beyond"}};
  for (const auto& [text, why] : cases) {
    const TypedNumber typed = read_number(text);
    EXPECT_FALSE(typed.number) << text;
    EXPECT_NE(typed.wrong.find(why), std::string::npos) << text << ": " << typed.wrong;
  }
}

TEST(ReadEdit, SetsAddsAndScales) {
  EXPECT_EQ((*read_edit("1/4").edit)(9), 0.25);
  EXPECT_EQ((*read_edit("-3").edit)(9), -3) << "a sign alone is part of the number";
  EXPECT_EQ((*read_edit("+=0.2").edit)(0.1), 0.3) << "without the noise of the sum";
  EXPECT_EQ((*read_edit("-= 1").edit)(9), 8);
  EXPECT_EQ((*read_edit("*=1/2").edit)(9), 4.5);
  EXPECT_EQ((*read_edit("/=,5").edit)(9), 18);
  EXPECT_FALSE(read_edit("/=0").edit);
  EXPECT_FALSE(read_edit("+=").edit);
}

TEST(ExactText, IsShortAndReadsBack) {
  EXPECT_EQ(exact_text(0.1), "0.1");
  EXPECT_EQ(exact_text(-0.0), "0");
  EXPECT_EQ(exact_text(120), "120");
  for (const double value : {1.0 / 3, 1e-300, 5e-324, 1.7e308, 50.123456789012345})
    EXPECT_EQ(read_number(exact_text(value)).number, value);
}

TEST(WithoutNoise, KeepsFifteenDigitsOfTheScale) {
  EXPECT_NE(100.2 - 100, 0.2);
  EXPECT_EQ(without_noise(100.2 - 100, 100), 0.2);
  EXPECT_EQ(without_noise(0.1 + 0.2, 0.3), 0.3);
  EXPECT_EQ(without_noise(1.0 / 3, 1), 0.33333333333333);
  EXPECT_EQ(without_noise(1e20, 1e20), 1e20);
  EXPECT_EQ(without_noise(0, 0), 0);
}

TEST(WhyOutside, TellsTheRange) {
  EXPECT_EQ(why_outside(0.5, unit_interval), "");
  EXPECT_EQ(why_outside(7, unit_interval), "is not in [0, 1]");
  EXPECT_EQ(why_outside(-3, positive), "is not greater than 0");
  EXPECT_EQ(why_outside(NAN, positive), "is not greater than 0");
}

}  // namespace
}  // namespace crest
