#include "render/vdls/quadtree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "render/vdls/proxy.h"
#include "tests/raycaster/fixture.h"

namespace crest::testing {
namespace {

// Nodes do not overlap, cover each leaf with samples, and go through at least as many layers as it has; with
// no threshold to no more.
TEST(ScreenQuadtree, CoversEachLeafOnce) {
  std::mt19937 random(7);
  for (const int threshold : {0, 3, 1000}) {
    const int leaves = 16, side = 5;
    std::vector<std::uint32_t> counts(leaves * leaves);
    for (int i = 0; i < leaves * leaves; ++i)
      counts[std::size_t(i)] =
          i % leaves < 7 ? 0 : std::uint32_t(40 + random() % 3) + 20u * std::uint32_t(i / leaves / 8);
    std::vector<int> layers(counts.size(), 0);
    const auto nodes = screen_quadtree(counts, leaves, side, threshold);
    for (const ScreenNode& node : nodes)
      for (int y = node.begin.y; y < node.begin.y + node.side; y += side)
        for (int x = node.begin.x; x < node.begin.x + node.side; x += side) {
          EXPECT_EQ(layers[std::size_t(y / side * leaves + x / side)], 0);
          layers[std::size_t(y / side * leaves + x / side)] = node.layers;
        }
    for (std::size_t i = 0; i < counts.size(); ++i) {
      EXPECT_GE(layers[i], int(counts[i]));
      EXPECT_LE(layers[i], int(counts[i]) + threshold);
    }
    EXPECT_EQ(nodes.size() == 1, threshold == 1000);
  }
}

TEST(ScreenQuadtree, BrothersAreCombinedLevelByLevel) {
  std::vector<std::uint32_t> counts(64, 10);
  EXPECT_EQ(screen_quadtree(counts, 8, 4, 0).size(), 1u);
  counts[0] = 20;  // its three brothers, and three at each of the two levels above
  EXPECT_EQ(screen_quadtree(counts, 8, 4, 0).size(), 10u);
  EXPECT_EQ(screen_quadtree(std::vector<std::uint32_t>(64, 0), 8, 4, 0).size(), 0u);
}

// Those that go through the most layers are drawn first, so that fewer and fewer are drawn.
TEST(Proxies, CornersBeyondALayer) {
  const Proxy proxy = proxy_of({ScreenNode{{0, 0}, 8, 5}, {{8, 0}, 8, 9}, {{0, 8}, 8, 1}});
  EXPECT_EQ(proxy.layers(), 9);
  EXPECT_EQ(proxy.corners_beyond(0), 18);
  EXPECT_EQ(proxy.corners_beyond(1), 12);
  EXPECT_EQ(proxy.corners_beyond(5), 6);
  EXPECT_EQ(proxy.corners_beyond(9), 0);
  EXPECT_EQ(proxy.corners.front(), glm::vec2(8, 0));
}

// A cube's projection is a polygon of four or six corners (of seven or fewer, as the paper has it), a pixel
// wider.
TEST(Proxies, ABoxProjectsToAConvexPolygon) {
  const Grid grid{glm::ivec3(9), glm::dvec3(1), glm::dvec3(0)};
  const Box box{grid.box_min(), grid.box_max()};
  const auto area = [](const Proxy& proxy) {
    double sum = 0;
    for (std::size_t i = 0; i < proxy.corners.size(); i += 3) {
      const glm::dvec2 a = proxy.corners[i], b = proxy.corners[i + 1], c = proxy.corners[i + 2];
      sum += std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
    }
    return sum;
  };
  const Proxy face = proxy_of(box, along_z(grid, 16), {100, 100}, 3);
  EXPECT_NEAR(area(face), 52 * 52, 0.1);  // half the picture each way, and a pixel all around
  EXPECT_EQ(face.layers(), 3);
  const Proxy oblique = proxy_of(box, whole_volume_camera(grid, 1), {100, 100}, 3);
  EXPECT_GT(area(oblique), 3000);
  EXPECT_LT(area(oblique), 100 * 100);
  Camera away = along_z(grid, 16);
  away.target = 2.0 * away.eye - away.target;
  EXPECT_EQ(proxy_of(box, away, {100, 100}, 3).layers(), 0);
}

}  // namespace
}  // namespace crest::testing
