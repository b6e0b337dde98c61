#include "app/picture_maker.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "app/preset_source.h"
#include "presets/preset_file.h"
#include "render/files/image.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"

namespace crest {
namespace {

TEST(Numbered, ASinglePictureKeepsItsName) {
  EXPECT_EQ(numbered("a/turn.png", 0, 1), "a/turn.png");
  EXPECT_EQ(numbered("a/turn.png", 0, 36), "a/turn-001.png");
  EXPECT_EQ(numbered("a/turn.png", 1999, 2000), "a/turn-2000.png");
  EXPECT_EQ(with_number("a/step.png", 0, 35), "a/step-000.png");
  EXPECT_EQ(with_number("a/step.png", 7, 1000), "a/step-0007.png");
}

// Each file of a turn opens as it looks: with its own camera.
TEST(PictureMaker, EachPictureKeepsThePresetAndItsCamera) {
  const std::filesystem::path folder = std::filesystem::path(::testing::TempDir()) / "picture_maker";
  std::filesystem::create_directories(folder);
  const auto volume = std::make_shared<const Volume>(make_builtin("sphere?n=16"));
  PictureJob job;
  job.preset = load_preset("onion");
  job.views = {{make_scene(volume, job.preset), "onion"}};
  job.camera = whole_volume_camera(volume->grid, 1);
  job.size = {16, 16};
  job.pictures = 2;
  job.path = folder / "turn.exr";
  PictureMaker maker;
  maker.start(job);
  std::optional<PictureMaker::Task::Outcome> outcome;
  while (!(outcome = maker.take())) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(outcome->error, "");
  EXPECT_EQ(maker.progress(), "");
  for (int i = 0; i < 2; ++i) {
    const Preset kept = load_preset_from(numbered(job.path, i, 2).string());
    EXPECT_EQ(kept.camera, turned(job.camera, i, 2));
    EXPECT_EQ(kept.transfer_function, job.preset.transfer_function);
  }
  std::filesystem::remove_all(folder);
}

TEST(PresetSource, APictureThatHoldsNoneIsRefused) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "no_preset.exr";
  write_image(file, {{1, 1}, {glm::vec4(1)}}, {});
  EXPECT_THROW(load_preset_from(file.string()), std::exception);
  write_image(file, {{1, 1}, {glm::vec4(1)}}, {}, "{ hostile");
  EXPECT_THROW(load_preset_from(file.string()), std::exception);
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace crest
