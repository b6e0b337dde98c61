#include "ui/recovery_banner.h"

#include "tests/ui/harness.h"

namespace crest::test {
namespace {

class RecoveryBanner : public Studio {
 protected:
  RecoveryBanner() {
    inputs.recovery = RecoveryOffer{"mine.json", "builtin:plume", 190, 1};
    frames(2);
  }
  std::optional<RecoveryAnswer> answer(const char* button) {
    move_to(center_of(std::string("recovery/") + button));
    press();
    release();
    return requests.recovery;
  }
};

TEST_F(RecoveryBanner, EachAnswerIsOneClick) {
  EXPECT_EQ(answer("Restore"), RecoveryAnswer::restore);
  frames(30);
  EXPECT_FALSE(requests.recovery);
  EXPECT_EQ(answer("Discard"), RecoveryAnswer::discard);
  frames(30);
  EXPECT_EQ(answer("Later"), RecoveryAnswer::later);
}

TEST_F(RecoveryBanner, IsThereOnlyWhileSomethingIsOffered) {
  const float with = center_of("view0").y;
  inputs.recovery.reset();
  frames(2);
  EXPECT_FALSE(has("recovery/Restore"));
  EXPECT_LT(center_of("view0").y, with) << "it takes no room";
}

TEST(AgeText, IsInTheLargestUnit) {
  EXPECT_EQ(age_text(-5), "just now");
  EXPECT_EQ(age_text(59), "just now");
  EXPECT_EQ(age_text(60), "1 minute ago");
  EXPECT_EQ(age_text(190), "3 minutes ago");
  EXPECT_EQ(age_text(7300), "2 hours ago");
  EXPECT_EQ(age_text(86400 * 6.9), "6 days ago");
  EXPECT_EQ(age_text(86400 * 30), "4 weeks ago");
}

}  // namespace
}  // namespace crest::test
