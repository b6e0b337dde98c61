#include "app/background_writer.h"

#include <gtest/gtest.h>

#include <future>
#include <stdexcept>
#include <vector>

namespace crest {
namespace {

TEST(BackgroundWriter, WritesWhatWasGivenLastAndLeavesOutWhatHasNotBegun) {
  std::vector<int> written;  // of the thread, until it is finished
  std::promise<void> begun, go_on;
  {
    BackgroundWriter writer;
    writer.start([&] {
      begun.set_value();
      go_on.get_future().wait();
      written.push_back(1);
    });
    begun.get_future().wait();  // nothing waits for the first one
    writer.start([&] { written.push_back(2); });
    writer.start([&] { written.push_back(3); });
    go_on.set_value();
  }
  EXPECT_EQ(written, (std::vector<int>{1, 3}));
}

TEST(BackgroundWriter, TellsOnceWhyTheLastOneFailed) {
  BackgroundWriter writer;
  writer.finish();
  EXPECT_EQ(writer.take_error(), "");
  writer.start([] { throw std::runtime_error("the disk is full"); });
  writer.finish();
  EXPECT_TRUE(writer.has_error());
  EXPECT_EQ(writer.take_error(), "the disk is full");
  EXPECT_EQ(writer.take_error(), "");
  writer.start([] {});
  writer.finish();
  EXPECT_FALSE(writer.has_error());
}

}  // namespace
}  // namespace crest
