#include "render/scene/float_precision.h"

#include <gtest/gtest.h>

#include "presets/names.h"
#include "presets/preset_file.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr glm::ivec2 picture{512, 512};

/// A volume of n^3 points, of which only the grid and the range are looked at.
std::shared_ptr<Volume> volume_of(int n, ValueRange range = {0, 1}, ScalarType type = ScalarType::float32) {
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = glm::ivec3(n);
  volume->statistics.range = range;
  volume->file_type = type;
  return volume;
}

TransferFunction tf_of(std::initializer_list<std::pair<double, double>> points, double unit_distance = 1) {
  TransferFunction tf;
  tf.unit_distance = unit_distance;
  for (const auto& [value, opacity] : points) {
    tf.points.emplace_back();
    tf.points.back().value = value;
    tf.points.back().opacity = opacity;
  }
  return tf;
}

Scene scene_of(TransferFunction tf, Mode mode) {
  Scene scene{volume_of(64), std::move(tf), {}};
  scene.rendering.mode = mode;
  return scene;
}

std::vector<std::string> warnings_of(const Scene& scene) {
  return scene_warnings(scene, whole_volume_camera(scene.volume->grid, 1), picture);
}

std::vector<std::string> warnings_from(const Camera& camera, glm::ivec2 size = picture) {
  return scene_warnings(scene_of(tf_of({{0, 0}, {1, 0.5}}), Mode::both), camera, size);
}

TEST(Limits, TheLibraryOnALargeVolumeHasNoWarning) {
  const auto volume = volume_of(512, {0, 255}, ScalarType::uint8);
  const auto presets = library();
  ASSERT_GE(presets.size(), 10U);
  for (const LibraryPreset& preset : presets)
    for (const auto& [mode, name] : names_of<Mode>()) {
      Scene scene = make_scene(volume, load_preset(std::string(preset.name)));
      scene.rendering.mode = mode;
      EXPECT_EQ(scene_warnings(scene, whole_volume_camera(volume->grid, 1), {4096, 4096}),
                std::vector<std::string>())
          << preset.name << ' ' << name;
    }
}

TEST(Limits, ALargeVolumeThatIsOpaqueWithinAVoxelHasNone) {
  Scene scene = scene_of(tf_of({{0, 0}, {1, 1}}), Mode::both);
  scene.volume = volume_of(512);
  EXPECT_EQ(warnings_of(scene).size(), 0U);
}

TEST(Limits, AMaterialThatAbsorbsMuchWithinARounding) {
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
    Scene scene = scene_of(tf_of({{0, 0}, {1, 0.9}}, 1e-3), mode);
    const auto warnings = warnings_of(scene);
    ASSERT_EQ(warnings.size(), 1U) << name_of(mode);
    EXPECT_NE(warnings[0].find("densest material"), std::string::npos);
    // What it advises helps, and nothing less does
    const double times = 255 * haze_rounding(scene);
    scene.tf.unit_distance *= 0.99 * times;
    EXPECT_EQ(warnings_of(scene).size(), 1U);
    scene.tf.unit_distance *= 1.02;
    EXPECT_EQ(warnings_of(scene).size(), 0U);
  }
  EXPECT_EQ(warnings_of(scene_of(tf_of({{0, 0}, {1, 0.9}}, 1e-3), Mode::peak_only)).size(), 0U);
}

TEST(Limits, WhatDvrDoesNotSampleIsNotDense) {
  const auto is_warned = [](const TransferFunction& tf, Mode mode, PeakForm form) {
    Scene scene = scene_of(tf, mode);
    scene.rendering.peak_form = form;
    return !warnings_of(scene).empty();
  };
  // A spike has a body; in PEAK_XOR_DVR only the paper's form samples it
  const TransferFunction spike =
      tf_of({{0, 1e-4}, {0.499, 1e-4}, {0.5, 0.9}, {0.501, 1e-4}, {1, 1e-4}}, 1e-3);
  for (const Mode mode : {Mode::dvr_only, Mode::both}) EXPECT_TRUE(is_warned(spike, mode, PeakForm::split));
  EXPECT_TRUE(is_warned(spike, Mode::peak_xor_dvr, PeakForm::paper));
  EXPECT_FALSE(is_warned(spike, Mode::peak_xor_dvr, PeakForm::split));
  // One of no width has none, and what lies outside the data is not there
  const TransferFunction line = tf_of({{0, 1e-4}, {0.5, 1e-4}, {0.5, 0.9}, {0.5, 1e-4}, {1, 1e-4}}, 1e-3);
  const TransferFunction outside = tf_of({{-2, 0.9}, {-1, 1e-4}, {2, 1e-4}, {3, 0.9}}, 1e-3);
  for (const Mode mode : {Mode::dvr_only, Mode::both, Mode::peak_xor_dvr}) {
    EXPECT_FALSE(is_warned(line, mode, PeakForm::split));
    EXPECT_FALSE(is_warned(outside, mode, PeakForm::split));
  }
  // A step is, on the side of its opaque corner; so is a region at the greatest value
  EXPECT_TRUE(is_warned(tf_of({{0, 0.9}, {0.5, 0.9}, {0.5, 0}, {1, 0}}, 1e-3), Mode::both, PeakForm::split));
  EXPECT_TRUE(is_warned(tf_of({{0, 0}, {1, 0}, {1, 0.9}}, 1e-3), Mode::both, PeakForm::split));
}

TEST(Limits, ValuesFarFromZero) {
  const auto count = [](ScalarType type, ValueRange range) {
    return volume_warnings(*volume_of(8, range, type)).size();
  };
  EXPECT_EQ(count(ScalarType::float64, {1e6, 1e6 + 1}), 1U);
  EXPECT_EQ(count(ScalarType::float64, {-1e6 - 1, -1e6}), 1U);
  EXPECT_EQ(count(ScalarType::int32, {2e9, 2e9 + 1000}), 1U);
  EXPECT_EQ(count(ScalarType::uint64, {1e18, 1.00000001e18}), 1U);
  // Nothing was lost: the file has no more digits, they are not needed, or there is no range
  EXPECT_EQ(count(ScalarType::float32, {1e6, 1e6 + 1}), 0U);
  EXPECT_EQ(count(ScalarType::uint16, {65000, 65010}), 0U);
  EXPECT_EQ(count(ScalarType::int32, {1e6, 1e6 + 10}), 0U);
  EXPECT_EQ(count(ScalarType::float64, {-1, 1}), 0U);
  EXPECT_EQ(count(ScalarType::float64, {1e6, 1e6 + 100}), 0U);
  EXPECT_EQ(count(ScalarType::float64, {1e6, 1e6}), 0U);
  EXPECT_EQ(count(ScalarType::float64, {0, 0}), 0U);

  Scene scene = scene_of(tf_of({{0, 0}, {1, 0.5}}), Mode::both);
  scene.volume = volume_of(64, {1e6, 1e6 + 1}, ScalarType::float64);
  ASSERT_EQ(warnings_of(scene).size(), 1U);
  EXPECT_NE(warnings_of(scene)[0].find("only 16 numbers"), std::string::npos) << warnings_of(scene)[0];
}

TEST(Limits, APixelAsNarrowAsARounding) {
  const Grid grid = volume_of(64)->grid;
  Camera camera = whole_volume_camera(grid, 1);
  EXPECT_EQ(warnings_from(camera).size(), 0U);
  camera.fov_y_degrees = 0.001;
  ASSERT_EQ(warnings_from(camera).size(), 1U);
  EXPECT_NE(warnings_from(camera)[0].find("roundings of a position"), std::string::npos);
  EXPECT_EQ(warnings_from(camera, {8, 8}).size(), 0U) << "its pixels are wider";
  // A narrow view from afar shows all of the volume
  const glm::dvec3 middle = grid.box_min() + 0.5 * grid.box_size();
  camera.eye = middle + (camera.eye - middle) * 3e4;
  EXPECT_EQ(warnings_from(camera).size(), 0U);
  // Of an eye in the very middle the nearest things do not count
  camera.eye = middle;
  camera.fov_y_degrees = 60;
  EXPECT_EQ(warnings_from(camera).size(), 0U);
  camera.fov_y_degrees = 1e-4;
  EXPECT_EQ(warnings_from(camera).size(), 1U);
}

}  // namespace
}  // namespace crest
