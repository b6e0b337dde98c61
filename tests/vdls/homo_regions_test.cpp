#include "render/vdls/homo_regions.h"

#include <gtest/gtest.h>

#include <random>

#include "tests/vdls/fixture.h"

namespace crest::testing {
namespace {

// Each bucket's box is the one around all cells that have values in it, by brute force.
TEST(HomoRegions, HoldEachCellThatHasAValueOfTheirs) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> noise(-1, 1);
  const Grid grid{{9, 7, 8}, {1, 2, 0.5}, {-3, 0, 4}};
  const auto volume =
      make_volume(grid, [&](glm::dvec3 p) { return p.x + 0.3 * p.y + (p.z > 6 ? 8 * noise(random) : 0); });
  const HomoRegions homo = find_homo_regions(*volume);
  for (int bucket = 0; bucket < HomoRegions::buckets; ++bucket) {
    const ValueRange values = homo.values_of(bucket);
    glm::ivec3 first(1000), last(-1000);
    for (int k = 0; k < 7; ++k)
      for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 8; ++i) {
          float least = volume->at(i, j, k), most = least;
          for (int corner = 1; corner < 8; ++corner) {
            const float value = volume->at(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
            least = std::min(least, value);
            most = std::max(most, value);
          }
          if (double(least) >= values.max || double(most) < values.min) continue;
          first = glm::min(first, glm::ivec3(i, j, k));
          last = glm::max(last, glm::ivec3(i, j, k) + 1);
        }
    const auto& region = homo.regions[std::size_t(bucket)];
    if (last.x < 0) {
      EXPECT_LT(region.last.x, region.first.x) << bucket;
    } else {
      EXPECT_EQ(region.first, first) << bucket;
      EXPECT_EQ(region.last, last) << bucket;
    }
  }
}

// Interpolation makes values between a cell's corners that no voxel has: they count.
TEST(HomoRegions, CountWhatInterpolationMakes) {
  const Grid grid{glm::ivec3(4), glm::dvec3(1), glm::dvec3(0)};
  const auto volume = make_volume(grid, [](glm::dvec3 p) { return p.x < 1.5 ? 0.0 : 1.0; });
  const auto box_of = [&](double value) {
    return visible_box(find_homo_regions(*volume), grid,
                       [&](ValueRange bucket) { return bucket.min <= value && value < bucket.max; });
  };
  EXPECT_EQ(box_of(0.5).min, glm::dvec3(1, 0, 0));
  EXPECT_EQ(box_of(0.5).max, glm::dvec3(2, 3, 3));
  EXPECT_TRUE(box_of(7).is_empty());
}

using LeapingLayers = VdlsTest;

// What is leapt over is what the TF makes transparent: fewer samples, the same picture, also after an edit.
TEST_F(LeapingLayers, FollowTheTransferFunction) {
  const auto volume = builtin("sphere?n=24");
  const ValueRange range = volume->statistics.range;
  const auto value = [&](double share) { return range.min + share * range.width(); };
  const Camera camera = whole_volume_camera(volume->grid, 1);
  double least = 1e9, most = 0;
  for (const double inner : {0.3, 0.5, 0.7, 0.9}) {
    Scene scene{volume, make_tf({point(value(0), 0), point(value(inner), 0), point(value(1), 0.5)}), {}};
    scene.rendering.mode = Mode::dvr_only;
    EXPECT_LT(difference(scene, camera, {}), rounding);
    const double samples = sum_of(counts(scene, camera, {40, 40}, Engine::vdls)).samples;
    least = std::min(least, samples);
    most = std::max(most, samples);
  }
  EXPECT_LT(least, 0.5 * most);
  Scene clear{volume, make_tf({point(value(0), 0)}), {}};
  clear.rendering.mode = Mode::dvr_only;
  EXPECT_LT(difference(clear, camera, {}), rounding);
  EXPECT_EQ(sum_of(counts(clear, camera, {40, 40}, Engine::vdls)).samples, 0);
}

}  // namespace
}  // namespace crest::testing
