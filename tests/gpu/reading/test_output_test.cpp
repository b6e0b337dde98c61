#include "tests/gpu/reading/test_output.h"

#include <gtest/gtest.h>

namespace crest::gpu {
namespace {

TEST(TestOutput, TellsWhatPassedFailedAndWasCutOff) {
  const TestOutput all = read_test_output(
      "Running main()\n"
      "[----------] 3 tests from A\n"
      "[ RUN      ] A.Passes\n"
      "[       OK ] A.Passes (3 ms)\n"
      "[ RUN      ] A.Fails\n"
      "a.cpp:7: Failure\n"
      "[  FAILED  ] A.Fails (1 ms)\n"
      "[ RUN      ] Some/A.Fails/two\n"
      "why\n"
      "[  FAILED  ] Some/A.Fails/two, where GetParam() = 2 (1 ms)\n"
      "[ RUN      ] A.Skips\n"
      "[  SKIPPED ] A.Skips (0 ms)\n"
      "[ RUN      ] A.Crashes\n"
      "the last words");
  EXPECT_EQ(all.passed, 1);
  EXPECT_EQ(all.skipped, 1);
  ASSERT_EQ(all.failed.size(), 2U);
  EXPECT_EQ(all.failed[0].name, "A.Fails");
  EXPECT_EQ(all.failed[0].output, "a.cpp:7: Failure\n");
  EXPECT_EQ(all.failed[1].name, "Some/A.Fails/two");
  ASSERT_EQ(all.unfinished.size(), 1U);
  EXPECT_EQ(all.unfinished[0].name, "A.Crashes");
  EXPECT_EQ(all.unfinished[0].output, "the last words\n");
}

TEST(TestOutput, TheSummaryCountsNothingTwice) {
  const TestOutput all = read_test_output(
      "[ RUN      ] A.Fails\n"
      "[  FAILED  ] A.Fails (1 ms)\n"
      "[  FAILED  ] 1 test, listed below:\n"
      "[  FAILED  ] A.Fails\n");
  EXPECT_EQ(all.failed.size(), 1U);
  EXPECT_TRUE(all.unfinished.empty());
}

TEST(TestOutput, TheTailIsWholeLines) {
  EXPECT_EQ(tail_of("one\ntwo\nthree\n", 8), "three\n");
  EXPECT_EQ(tail_of("short\n", 8), "short\n");
}

}  // namespace
}  // namespace crest::gpu
