#include "presets/nearest_word.h"

#include <gtest/gtest.h>

namespace crest {
namespace {

TEST(NearestWord, DistanceCountsChangedAddedLeftOutAndSwappedLetters) {
  EXPECT_EQ(edit_distance("", ""), 0);
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("preset", "PRESET"), 0);
  EXPECT_EQ(edit_distance("prset", "preset"), 1);
  EXPECT_EQ(edit_distance("presset", "preset"), 1);
  EXPECT_EQ(edit_distance("pretet", "preset"), 1);
  EXPECT_EQ(edit_distance("perset", "preset"), 1);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
  EXPECT_EQ(edit_distance("abcd", "badc"), 2);
}

TEST(NearestWord, IsTheOneThatWasMeant) {
  const std::vector<std::string_view> known = {"render", "report", "compare", "peaks", "PEAK_XOR_DVR"};
  EXPECT_EQ(nearest_word("rendr", known), "render");
  EXPECT_EQ(nearest_word("reprot", known), "report");
  EXPECT_EQ(nearest_word("peak_xor_dvr", known), "PEAK_XOR_DVR");
  EXPECT_EQ(nearest_word("comp", known), "compare") << "a beginning";
  EXPECT_EQ(nearest_word("Peak_X", known), "PEAK_XOR_DVR") << "a beginning";
  EXPECT_EQ(nearest_word("bogus", known), "");
  EXPECT_EQ(nearest_word("r", known), "");
  EXPECT_EQ(nearest_word("", known), "");
  EXPECT_EQ(nearest_word(std::string(1 << 20, 'r'), known), "") << "no word, and not measured";
  EXPECT_EQ(nearest_word("render", {}), "");
}

TEST(NearestWord, EndsAMessage) {
  EXPECT_EQ(did_you_mean("--prset", {"--preset", "--step"}), "; did you mean --preset?");
  EXPECT_EQ(did_you_mean("--bogus", {"--preset", "--step"}), "");
}

}  // namespace
}  // namespace crest
