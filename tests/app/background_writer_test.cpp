#include "app/background_writer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

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

TEST(BackgroundWriter, WritesAtOnceWhereNoThreadIsToBeHad) {
  const auto write = [] {
    if (geteuid() == 0 && setuid(54322) != 0) _exit(2);  // root may start any number
    const rlimit none{0, 0};
    setrlimit(RLIMIT_NPROC, &none);
    alarm(60);
    BackgroundWriter writer;
    bool is_written = false;
    writer.start([&] { is_written = true; });
    const bool is_at_once = is_written;
    writer.start([] { throw std::runtime_error("the disk is full"); });
    _exit(is_at_once && writer.take_error() == "the disk is full" ? 0 : 1);
  };
  EXPECT_EXIT(write(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace crest
