#include "app/thumbnail.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <mutex>
#include <thread>

#include "app/thumbnail_maker.h"
#include "app/thumbnail_store.h"
#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/volume/builtin.h"
#include "tests/debug_context.h"

namespace crest {
namespace {

using namespace std::chrono_literals;

constexpr int width = thumbnail_size.x, height = thumbnail_size.y;

Thumbnail noise(std::uint32_t seed) {
  Thumbnail thumbnail;
  for (std::uint8_t& byte : thumbnail.rgb) byte = std::uint8_t((seed = seed * 1664525 + 1013904223) >> 24);
  return thumbnail;
}

glm::ivec3 pixel_of(const Thumbnail& thumbnail, int x, int y) {
  const std::size_t at = 3 * (std::size_t(y) * std::size_t(width) + std::size_t(x));
  return {thumbnail.rgb[at], thumbnail.rgb[at + 1], thumbnail.rgb[at + 2]};
}

TEST(Thumbnail, OutlivesItsPng) {
  const Thumbnail thumbnail = noise(1);
  const auto read = thumbnail_from_png(png_of(thumbnail));
  ASSERT_TRUE(read);
  EXPECT_EQ(*read, thumbnail);
}

TEST(Thumbnail, WhatIsNoThumbnailIsNone) {
  const std::string png = png_of(noise(2));
  EXPECT_FALSE(thumbnail_from_png(""));
  EXPECT_FALSE(thumbnail_from_png("no picture"));
  EXPECT_FALSE(thumbnail_from_png(png.substr(0, png.size() / 2)));
  std::string larger = png;
  larger[19] = char(larger[19] + 1);  // the width that its header tells
  EXPECT_FALSE(thumbnail_from_png(larger));
}

TEST(Thumbnail, IsTheMeanOfThePixelsUnderEach) {
  const glm::ivec2 size{2 * width, 2 * height};
  std::vector<glm::u8vec4> rgba;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) rgba.emplace_back(x % 2 ? 200 : 100, y % 2 ? 50 : 10, x / 2 % 256, 255);
  const Thumbnail small = shrunk(rgba, size);
  EXPECT_EQ(pixel_of(small, 0, 0), glm::ivec3(150, 30, 0));
  EXPECT_EQ(pixel_of(small, 77, 30), glm::ivec3(150, 30, 77));
}

TEST(Thumbnail, IsTheMiddleOfAWiderOrHigherPicture) {
  for (const glm::ivec2 size :
       {glm::ivec2(3 * width, height), glm::ivec2(width, 3 * height), glm::ivec2(5, 300)}) {
    std::vector<glm::u8vec4> rgba(std::size_t(size.x) * std::size_t(size.y));
    const std::size_t middle = std::size_t(size.y / 2) * std::size_t(size.x) + std::size_t(size.x / 2);
    rgba[middle].r = 255;
    const Thumbnail small = shrunk(rgba, size);
    int brightest = 0;
    glm::ivec2 place{0};
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (const int red = pixel_of(small, x, y).x; red > brightest) brightest = red, place = {x, y};
    EXPECT_GT(brightest, 0);
    EXPECT_NEAR(place.x, width / 2, width / 5 + 1);
    EXPECT_NEAR(place.y, height / 2, 27);
  }
}

TEST(Thinned, KeepsTheBoxAndTheField) {
  const Volume volume = make_builtin("linear?n=65");
  const Volume small = with_at_most(volume, 17);
  EXPECT_EQ(small.grid.dims, glm::ivec3(17));
  EXPECT_EQ(small.grid.box_max(), volume.grid.box_max());
  EXPECT_EQ(small.at(3, 5, 7), volume.at(12, 20, 28));
  EXPECT_EQ(small.at(16, 16, 16), volume.at(64, 64, 64));
  const Volume same = with_at_most(volume, 96);
  EXPECT_EQ(same.values, volume.values);
}

class Store : public ::testing::Test {
 protected:
  Store() { std::filesystem::remove_all(folder); }
  ~Store() override { std::filesystem::remove_all(folder); }
  static Thumbnail shown(std::uintptr_t texture) {
    std::vector<glm::u8vec4> rgba(std::size_t(width) * std::size_t(height));
    glGetTextureImage(GLuint(texture), 0, GL_RGBA, GL_UNSIGNED_BYTE, GLsizei(4 * rgba.size()), rgba.data());
    return shrunk(rgba, thumbnail_size);
  }

  testing::DebugContext context;
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("crest_thumbnails_" + std::to_string(::getpid()));
};

TEST_F(Store, HoldsNoMoreTexturesThanAFrameNeeds) {
  constexpr std::size_t most = 8;
  ThumbnailStore store({});
  const auto use = [&](int first, int last) {
    for (int i = first; i < last; ++i)
      if (store.texture(std::to_string(i)) == 0) store.show(std::to_string(i), noise(std::uint32_t(i)));
  };
  for (int i = 0; i < 100; ++i) {
    store.begin_frame(most);
    use(i, i + 2);
    EXPECT_LE(store.count(), most + 2);
  }
  store.begin_frame(most);
  use(0, 20);
  store.begin_frame(most);
  EXPECT_EQ(store.count(), 20U) << "the frame that is on the screen names them";
  EXPECT_EQ(shown(store.texture("7")), noise(7));
  store.begin_frame(most);
  EXPECT_LE(store.count(), most);
  EXPECT_EQ(shown(store.texture("7")), noise(7)) << "what was used last stays";
}

TEST_F(Store, APictureThatIsReplacedLivesThroughThisFrameAndTheNext) {
  ThumbnailStore store({});
  store.show("a", noise(1));
  const GLuint old = GLuint(store.texture("a"));
  store.show("a", noise(2));
  EXPECT_TRUE(glIsTexture(old));
  EXPECT_EQ(shown(store.texture("a")), noise(2));
  store.begin_frame();
  EXPECT_TRUE(glIsTexture(old));
  store.begin_frame();
  EXPECT_FALSE(glIsTexture(old));
}

TEST_F(Store, APictureIsThereAtTheNextStart) {
  ThumbnailStore first(folder);
  EXPECT_EQ(first.texture("a"), 0U);
  first.show("a", noise(1));
  EXPECT_EQ(shown(first.texture("a")), noise(1));
  EXPECT_EQ(ThumbnailStore(folder).texture("a"), 0U) << "it is not written yet";
  first.write("a", noise(1));
  first.write("b", noise(2));
  first.write("a", noise(3));
  ThumbnailStore second(folder);
  ASSERT_NE(second.texture("a"), 0U);
  EXPECT_EQ(shown(second.texture("a")), noise(3));
  EXPECT_EQ(shown(second.texture("b")), noise(2));
  EXPECT_EQ(second.texture("c"), 0U);
}

TEST_F(Store, ADamagedFileIsNoPicture) {
  ThumbnailStore(folder).write("a", noise(1));
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    std::ofstream(entry.path()) << "damage";
  EXPECT_EQ(ThumbnailStore(folder).texture("a"), 0U);
}

TEST_F(Store, NoFolderIsNoError) {
  ThumbnailStore store("");
  store.show("a", noise(1));
  store.write("a", noise(1));
  EXPECT_EQ(shown(store.texture("a")), noise(1));
}

/// Draws what a test says, and counts.
class Maker : public ::testing::Test {
 protected:
  ThumbnailMaker::Draw make_draw() {
    return [this](const ThumbnailJob& job) {
      ++draws;
      while (is_held) std::this_thread::sleep_for(1ms);
      if (job.key == "bad") throw Error("no luck");
      return noise(std::uint32_t(job.key.front()));
    };
  }
  static ThumbnailJob job(const std::string& key) { return {key, nullptr, "", {}}; }
  std::vector<std::string> finish() {
    std::vector<std::string> keys;
    while (maker.is_busy()) {
      for (const auto& made : maker.take()) {
        EXPECT_EQ(made.thumbnail, noise(std::uint32_t(made.key.front())));
        keys.push_back(made.key);
      }
      std::this_thread::sleep_for(1ms);
    }
    return keys;
  }

  std::atomic<bool> is_held = false;
  std::atomic<int> draws = 0;
  std::mutex mutex;
  std::vector<std::string> written;  ///< keys, once the maker is gone or idle
  std::optional<ThumbnailMaker> maker_place{std::in_place,
                                            [this](const std::string& key, const Thumbnail&) {
                                              const std::scoped_lock lock(mutex);
                                              written.push_back(key);
                                            },
                                            [this] { return make_draw(); }};
  ThumbnailMaker& maker = *maker_place;
};

TEST_F(Maker, MakesWhatIsWantedInOrderAgainAndAgain) {
  maker.want({job("a"), job("b"), job("c")});
  EXPECT_EQ(finish(), (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_FALSE(maker.is_busy());
  maker.want({job("d")});
  EXPECT_EQ(finish(), std::vector<std::string>{"d"});
}

TEST_F(Maker, WhatIsNoLongerWantedIsNotBegun) {
  is_held = true;
  maker.want({job("a"), job("b"), job("c")});
  while (draws == 0) std::this_thread::sleep_for(1ms);
  maker.want({job("a"), job("d")});  // `a` is being drawn
  is_held = false;
  EXPECT_EQ(finish(), (std::vector<std::string>{"a", "d"}));
}

TEST_F(Maker, WhatFailsIsNotTriedAgain) {
  maker.want({job("bad"), job("a")});
  EXPECT_EQ(finish(), std::vector<std::string>{"a"});
  maker.want({job("bad")});
  EXPECT_EQ(finish(), std::vector<std::string>{});
  EXPECT_EQ(draws, 2);
}

TEST_F(Maker, WhatIsMadeOrGivenIsWrittenInTheThreadAlsoAtTheEnd) {
  maker.want({job("a")});
  finish();
  maker.keep("given", noise(1));
  maker.keep("last", noise(2));
  maker_place.reset();
  EXPECT_EQ(written, (std::vector<std::string>{"a", "given", "last"}));
}

TEST_F(Maker, ABurstDoesNotWaitForTheEndOfTheLast) {
  // What draws takes long to go, as a context does; the window must not
  std::atomic<bool> may_go = false;
  const auto slow = [&] {
    const std::shared_ptr<int> lives(new int(0), [&](const int* one) {
      while (!may_go) std::this_thread::sleep_for(1ms);
      delete one;
    });
    return [lives](const ThumbnailJob&) { return noise('a'); };
  };
  ThumbnailMaker other(nullptr, slow);
  other.want({job("a")});
  while (!other.has_news()) std::this_thread::sleep_for(1ms);
  other.take();
  other.want({job("b")});  // would hang
  may_go = true;
  while (!other.has_news()) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(other.take()[0].key, "b");
}

TEST(MakerOffscreen, DrawsAPresetOnAVolume) {
  ThumbnailMaker maker;
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=24"));
  const auto onion = [] { return load_preset("onion"); };
  maker.want({{"given", volume, "", onion}, {"read", nullptr, "builtin:sphere?n=24", onion}});
  std::vector<ThumbnailMaker::Made> made;
  while (maker.is_busy()) {
    for (auto& one : maker.take()) made.push_back(std::move(one));
    std::this_thread::sleep_for(5ms);
  }
  ASSERT_EQ(made.size(), 2U);
  EXPECT_EQ(made[0].thumbnail, made[1].thumbnail);
  const glm::ivec3 middle = pixel_of(made[0].thumbnail, width / 2, height / 2);
  EXPECT_GT(middle.x + middle.y + middle.z, 60) << "shells of a sphere are in the middle";
  EXPECT_EQ(pixel_of(made[0].thumbnail, 1, 1), glm::ivec3(0));
}

}  // namespace
}  // namespace crest
