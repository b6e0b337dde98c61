#include "render/raycaster/drawn_parts.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <random>

#include "render/scene/camera.h"

namespace crest {
namespace {

/// Whether the ray of a pixel meets the box: before the eye, in perspective.
bool meets(const Camera& camera, glm::ivec2 size, glm::ivec2 pixel, const Box& box) {
  const CameraFrame frame = camera_frame(camera);
  const bool is_parallel = camera.projection == Projection::parallel;
  const glm::dvec2 plane = (2.0 * (glm::dvec2(pixel) + 0.5) / glm::dvec2(size) - 1.0) * glm::dvec2(1, -1) *
                           glm::dvec2(aspect_of(size), 1) * std::tan(glm::radians(camera.fov_y_degrees / 2));
  const glm::dvec3 aside = plane.x * frame.u + plane.y * frame.v;
  const glm::dvec3 direction = is_parallel ? frame.w : frame.w + aside;
  const glm::dvec3 origin =
      is_parallel ? camera.eye + glm::length(camera.target - camera.eye) * aside : camera.eye;
  const glm::dvec3 a = (box.min - origin) / direction, b = (box.max - origin) / direction;
  const glm::dvec3 in = glm::min(a, b), out = glm::max(a, b);
  return std::max({in.x, in.y, in.z, is_parallel ? -1e300 : 0.0}) <= std::min({out.x, out.y, out.z});
}

// Eyes outside and inside, near faces and far away; in both projections.
TEST(DrawnParts, HoldEveryRayThatMeetsABoxOnce) {
  std::mt19937 random(5);
  const auto unit = [&] { return std::uniform_real_distribution<double>(0, 1)(random); };
  const auto vector = [&] {
    const double x = unit(), y = unit(), z = unit();
    return glm::dvec3(x, y, z);
  };
  const glm::ivec2 size(75, 41);
  const Tile tile{{5, 0}, {75, 38}};
  int left_out = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Camera camera;
    camera.eye = 0.5 + (vector() - 0.5) * (trial % 3 == 0 ? 1.0 : trial % 3 == 1 ? 4.0 : 1e3);
    camera.target = vector();
    camera.fov_y_degrees = trial % 3 == 2 ? 0.1 : 10 + 80 * unit();
    if (trial % 2) camera.projection = Projection::parallel;
    std::vector<Box> boxes;
    const glm::dvec3 least = 0.3 * vector();
    const Box rendered{least, least + 0.6};
    for (int i = 0; i < 4; ++i) {
      const glm::dvec3 low = vector();
      boxes.push_back({low, low + 0.2 * vector()});
    }
    const auto parts = parts_that_meet(boxes, rendered, camera, size, tile);
    for (int y = tile.begin.y; y < tile.end.y; ++y)
      for (int x = tile.begin.x; x < tile.end.x; ++x) {
        int held = 0;
        for (const Tile& part : parts)
          held += x >= part.begin.x && x < part.end.x && y >= part.begin.y && y < part.end.y;
        bool met = false;
        for (const Box& box : boxes) {
          const Box within{glm::max(box.min, rendered.min), glm::min(box.max, rendered.max)};
          met |= !within.is_empty() && meets(camera, size, {x, y}, within);
        }
        ASSERT_LE(held, 1);
        ASSERT_GE(held, int(met)) << trial << ": " << x << ", " << y;
        left_out += held == 0;
      }
  }
  EXPECT_GT(left_out, 300 * size.x * size.y / 4);
}

// Tile by tile, two pictures in turn, and after the boxes changed.
TEST(DrawnParts, AreTheSameWhereTheyAreKept) {
  PictureParts kept;
  const Box box{glm::dvec3(-1), glm::dvec3(1)};
  Camera camera;
  camera.eye = {2.9, -5.2, 2.6};
  camera.fov_y_degrees = 30;
  Camera other = camera;
  other.eye.x = 0;
  const glm::ivec2 size(200, 120);
  std::vector<Box> boxes = divided(box);
  for (int round = 0; round < 2; ++round) {
    for (int row = 0; row < size.y; row += 37)
      for (const Camera& eye : {camera, other}) {
        const Tile tile{{0, row}, {size.x, std::min(row + 37, size.y)}};
        const auto whole = parts_that_meet(boxes, box, eye, size, tile),
                   part = kept.that_meet(boxes, box, eye, size, tile);
        ASSERT_EQ(whole.size(), part.size());
        for (std::size_t i = 0; i < whole.size(); ++i) {
          EXPECT_EQ(whole[i].begin, part[i].begin);
          EXPECT_EQ(whole[i].end, part[i].end);
        }
      }
    boxes.resize(boxes.size() / 2);
  }
}

TEST(DrawnParts, FollowTheOutlineOfADividedBox) {
  const Box box{glm::dvec3(-1), glm::dvec3(1)};
  Camera camera;
  camera.eye = {2.9, -5.2, 2.6};
  camera.fov_y_degrees = 30;
  const glm::ivec2 size(512);
  int drawn = 0, met = 0;
  for (const Tile& part : parts_that_meet(divided(box), box, camera, size, {{0, 0}, size}))
    drawn += (part.end.x - part.begin.x) * (part.end.y - part.begin.y);
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) met += meets(camera, size, {x, y}, box);
  EXPECT_LT(drawn, 1.25 * met);
}

}  // namespace
}  // namespace crest
