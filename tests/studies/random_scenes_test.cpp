#include "render/studies/random/scenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <set>

#include "render/classify/classification.h"
#include "render/scene/camera.h"
#include "render/studies/random/kinds.h"

namespace crest {
namespace {

/// All of a scene but its camera, whose numbers need not be the same to the last bit with another C library.
std::string content_of(const RandomScene& random) {
  const Volume& volume = *random.scene.volume;
  const std::vector<float> values = volume.values.to_floats();
  std::vector<double> numbers(values.begin(), values.end());
  const auto add = [&](const glm::dvec3& v) { numbers.insert(numbers.end(), {v.x, v.y, v.z}); };
  for (const glm::dvec3& v : {volume.grid.origin, volume.grid.spacing, glm::dvec3(volume.grid.dims)}) add(v);
  numbers.push_back(random.scene.tf.unit_distance);
  for (const ControlPoint& point : random.scene.tf.points) {
    numbers.insert(numbers.end(), {point.value, point.opacity, double(point.surface.mode),
                                   point.surface.opacity.value_or(-1)});
    add(point.color);
  }
  std::string bytes(numbers.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return random.field + random.features + random.view + bytes;
}

/// FNV-1a.
std::uint64_t hash_of(std::uint64_t seed) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const RandomScene& scene : random_scenes(seed))
    for (const char c : content_of(scene)) hash = (hash ^ std::uint8_t(c)) * 0x100000001b3u;
  return hash;
}

TEST(RandomScenes, AreThoseOfTheirSeed) {
  EXPECT_EQ(hash_of(1), hash_of(1));
  const auto a = random_scenes(1), again = random_scenes(1), b = random_scenes(2);
  ASSERT_EQ(a.size(), std::size_t(random_scene_count));
  std::set<std::string> different;
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].camera, again[i].camera);
    for (const auto* scenes : {&a, &b}) different.insert(content_of((*scenes)[i]));
  }
  EXPECT_EQ(different.size(), 2 * a.size());
}

// What was measured of a seed can be measured again, also elsewhere: whoever changes the generator changes
// this, and what docs/measured.md says of its scenes.
TEST(RandomScenes, StayTheSame) { EXPECT_EQ(hash_of(1), 1612844093372906622u); }

TEST(RandomScenes, HaveEachKindEquallyOften) {
  const auto expect_spread = [](const std::map<std::string, int>& counts, std::size_t kinds) {
    EXPECT_EQ(counts.size(), kinds);
    for (const auto& [name, count] : counts) EXPECT_EQ(count * int(kinds), random_scene_count) << name;
  };
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    std::map<std::string, int> fields, features, views;
    for (const RandomScene& scene : random_scenes(seed)) {
      ++fields[scene.field];
      ++features[scene.features];
      ++views[scene.view];
      EXPECT_EQ(scene.labels, scene.field == "labels");
    }
    expect_spread(fields, field_kinds().size());
    expect_spread(features, feature_kinds().size());
    expect_spread(views, view_kinds().size());
  }
}

TEST(RandomScenes, AreScenesThatAllModesShow) {
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const RandomScene& random : random_scenes(seed)) {
      SCOPED_TRACE(random.field + ", " + random.features + ", " + random.view);
      const auto& [volume, tf, rendering] = random.scene;
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GE(volume->grid.dims[axis], 16);
        EXPECT_LE(volume->grid.dims[axis], 40);
      }
      EXPECT_TRUE(std::ranges::is_sorted(tf.points, {}, &ControlPoint::value));
      for (const ControlPoint& point : tf.points) {
        EXPECT_GE(point.opacity, 0);
        EXPECT_LE(point.opacity, 1);
      }
      EXPECT_FALSE(classify(tf, surface_range(random.scene)).surfaces.empty());
      EXPECT_NO_THROW(camera_frame(random.camera));
      if (!random.labels) continue;
      const std::vector<float> values = volume->values.to_floats();
      const std::set<float> labels(values.begin(), values.end());
      EXPECT_EQ(labels, (std::set<float>{0, 1, 2, 3, 4}));
    }
}

/// The least distance of two neighbouring points, apart from those at one value, as a share of the range.
double least_gap(const Scene& scene) {
  double least = 1;
  for (std::size_t i = 1; i < scene.tf.points.size(); ++i)
    if (const double gap = scene.tf.points[i].value - scene.tf.points[i - 1].value; gap > 0)
      least = std::min(least, gap / scene.volume->statistics.range.width());
  return least;
}

TEST(RandomScenes, AreWhatTheirKindsSay) {
  int steps = 0, spikes = 0, opaque = 0, hits = 0;
  for (std::uint64_t seed = 0; seed < 20; ++seed)
    for (const auto& [field, features, view, labels, scene, camera] : random_scenes(seed)) {
      const auto& points = scene.tf.points;
      const auto same_value = [](const auto& a, const auto& b) { return a.value == b.value; };
      const Grid& grid = scene.volume->grid;
      const bool in_box = glm::all(glm::lessThan(grid.box_min(), camera.eye)) &&
                          glm::all(glm::lessThan(camera.eye, grid.box_max()));
      EXPECT_EQ(in_box, view == "inside") << view;
      if (features == "steps") steps += std::ranges::adjacent_find(points, same_value) != points.end();
      if (features == "spikes") spikes += least_gap(scene) < 1e-3;
      if (features == "opaque") opaque += std::ranges::max(points, {}, &ControlPoint::opacity).opacity == 1;
      if (features == "pairs of points") {
        EXPECT_LT(least_gap(scene), 1e-5);
      }
      if (labels)  // some have features at a label's value
        hits += std::ranges::any_of(
            points, [](const auto& p) { return p.value == std::round(p.value) && p.value >= 0; });
    }
  const int each = 20 * 2;
  EXPECT_EQ(steps, each);
  EXPECT_GT(spikes, each / 2);  // the others have no width
  EXPECT_EQ(opaque, each);
  EXPECT_GT(hits, each / 3);
  EXPECT_LT(hits, each);
}

}  // namespace
}  // namespace crest
