#include "app/volume_loader.h"

#include <gtest/gtest.h>

#include <chrono>
#include <future>
#include <thread>

#include "presets/error.h"

namespace crest::test {
namespace {

/// A reader that begins to return when it is told to.
class SlowReader {
 public:
  VolumeLoader::Read read() const {
    return [released = released_](const std::string& source, const Reading& reading) {
      tell(reading.progress, 0.25);
      if (source.starts_with("until stopped")) {
        while (!reading.stop.stop_requested()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
      }
      if (source.starts_with("slow")) released.wait();
      if (source.ends_with("bad")) throw Error(source + ": is bad");
      Volume volume;
      volume.name = source;
      return volume;
    };
  }
  void release() { release_.set_value(); }

 private:
  std::promise<void> release_;
  std::shared_future<void> released_ = release_.get_future().share();
};

VolumeLoader::Result result_of(VolumeLoader& loader) {
  while (true) {
    if (auto result = loader.take()) return *result;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
}

void wait_for_threads(const VolumeLoader& loader) {
  while (loader.has_thread()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

TEST(VolumeLoader, ReadsBesideTheCaller) {
  SlowReader reader;
  VolumeLoader loader(reader.read());
  EXPECT_FALSE(loader.is_loading());
  EXPECT_FALSE(loader.take());
  loader.start("slow");
  EXPECT_TRUE(loader.is_loading());
  EXPECT_EQ(loader.source(), "slow");
  EXPECT_FALSE(loader.take());
  reader.release();
  const auto result = result_of(loader);
  EXPECT_EQ(result.source, "slow");
  ASSERT_TRUE(result.volume);
  EXPECT_EQ(result.volume->name, "slow");
  EXPECT_FALSE(loader.is_loading());
  EXPECT_FALSE(loader.take()) << "told once";
}

TEST(VolumeLoader, TellsHowMuchIsRead) {
  SlowReader reader;
  VolumeLoader loader(reader.read());
  EXPECT_FALSE(loader.share()) << "nothing is read";
  loader.start("slow");
  EXPECT_FALSE(loader.share()) << "not at once";
  while (!loader.share()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(*loader.share(), 0.25);
  loader.start("slow");
  EXPECT_FALSE(loader.share()) << "of the one before";
  loader.cancel();
  EXPECT_FALSE(loader.share());
  reader.release();
  wait_for_threads(loader);
}

TEST(VolumeLoader, TheLastOneCounts) {
  SlowReader reader;
  VolumeLoader loader(reader.read());
  loader.start("slow");
  loader.start("other");
  EXPECT_EQ(loader.source(), "other");
  EXPECT_EQ(result_of(loader).source, "other") << "it does not wait for the first";
  EXPECT_TRUE(loader.has_thread());
  reader.release();
  wait_for_threads(loader);
  EXPECT_FALSE(loader.take()) << "what nobody waits for is dropped";
}

TEST(VolumeLoader, IsCancelledAtOnce) {
  SlowReader reader;
  VolumeLoader loader(reader.read());
  loader.start("slow");
  loader.cancel();
  EXPECT_FALSE(loader.is_loading());
  EXPECT_TRUE(loader.has_thread());
  reader.release();
  wait_for_threads(loader);
  EXPECT_FALSE(loader.take());
}

TEST(VolumeLoader, MayGoWhileAThreadReads) {
  SlowReader reader;
  { VolumeLoader(reader.read()).start("slow"); }  // would not return if it waited
  reader.release();
}

TEST(VolumeLoader, AsksWhatIsNotWantedToStop) {
  SlowReader reader;
  VolumeLoader loader(reader.read());
  loader.start("until stopped");
  loader.start("other");
  EXPECT_EQ(result_of(loader).source, "other");
  wait_for_threads(loader);  // would not return
  loader.start("until stopped");
  loader.cancel();
  wait_for_threads(loader);
}

TEST(VolumeLoader, TellsWhyNot) {
  VolumeLoader loader(SlowReader().read());
  loader.start("bad");
  const auto result = result_of(loader);
  EXPECT_FALSE(result.volume);
  EXPECT_EQ(result.error, "bad: is bad");
}

}  // namespace
}  // namespace crest::test
