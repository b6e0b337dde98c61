#include <gtest/gtest.h>

#include <cmath>

#include "tests/reference/rays.h"

// inside = {f >= v}; a crossing is a change between two parts of positive length.
namespace crest::testing {
namespace {

/// A surface of half opacity at each value, and nothing else.
TransferFunction surfaces_at(const std::vector<double>& values) {
  TransferFunction tf;
  const auto add = [&](double value, double opacity) {
    tf.points.emplace_back();
    tf.points.back().value = value;
    tf.points.back().opacity = opacity;
  };
  add(-1e6, 0);
  for (const double value : values) {
    add(value, 0);
    add(value, 0.5);
    add(value, 0);
  }
  add(1e6, 0);
  return tf;
}

int crossings_of(const std::vector<float>& values, std::vector<double> surfaces) {
  const Scene scene = scene_of(profile(values), surfaces_at(surfaces));
  const int size = int(values.size()) - 1;
  const auto count = [&](glm::dvec3 eye, glm::dvec3 target) {
    const OneRay ray = along(scene, eye, target, Answer::crossings);
    EXPECT_NEAR(ray.color.a, 1 - std::pow(0.5, ray.crossings), 1e-15);
    return ray.crossings;
  };
  const int there = count({-5, 0.5, 0.5}, {1, 0.5, 0.5});
  EXPECT_EQ(count({size + 5.0, 0.5, 0.5}, {0, 0.5, 0.5}), there) << "backwards";
  EXPECT_EQ(count({-5, 0.0, 0.5}, {1, 0.0, 0.5}), there) << "in a face";
  EXPECT_EQ(count({-5, 1.0, 0.5}, {1, 1.0, 0.5}), there) << "in the upper face";
  EXPECT_EQ(count({-5, 1.0, 1.0}, {1, 1.0, 1.0}), there) << "along an edge";
  EXPECT_EQ(count({-1, 0.31, 0.4}, {double(size + 1), 0.62, 0.57}), there) << "aslant";
  return there;
}

TEST(ReferenceCrossings, OfAProfile) {
  EXPECT_EQ(crossings_of({-1, 0, 2, 0}, {1}), 2);
  EXPECT_EQ(crossings_of({-1, 0, 2, 0}, {2}), 0) << "a touch from below";
  EXPECT_EQ(crossings_of({-1, 4, 2, 4}, {2}), 1) << "a touch from above";
  EXPECT_EQ(crossings_of({-1, 0, 2, 2, 0}, {2}), 2) << "a part on the value is inside";
  EXPECT_EQ(crossings_of({-1, 0, 2, 4}, {2}), 1) << "at a face";
  EXPECT_EQ(crossings_of({4, 2, 0, -1}, {2}), 1);
  EXPECT_EQ(crossings_of({4, 2, 2, 0, -1}, {2}), 1);
  EXPECT_EQ(crossings_of({-1, 2, 2, 2, 4}, {2}), 1);
  EXPECT_EQ(crossings_of({-1, 0, 2}, {2}), 0) << "reached where the box ends";
  EXPECT_EQ(crossings_of({2, 0, -1}, {2}), 0);
  EXPECT_EQ(crossings_of({-1, 0, 2, 2}, {2}), 1) << "and stayed on";
  EXPECT_EQ(crossings_of({2, 2, 4, -1}, {2}), 1);
  EXPECT_EQ(crossings_of({2, 2, 2}, {2}), 0);
  EXPECT_EQ(crossings_of({0, 2, 4}, {0}), 0) << "the field's minimum";
  EXPECT_EQ(crossings_of({-1, 5, -1, 5, 2}, {0, 1, 2, 3, 4}), 5 + 5 + 5 + 2);
}

TEST(ReferenceCrossings, ByMultiplesOfAThird) {  // which float32 and the TF's double round differently
  std::vector<float> values;
  for (int i = 0; i < 20; ++i) values.push_back(float(i) / 3);
  EXPECT_EQ(crossings_of(values, {double(1.0f / 3), double(7.0f / 3), 11.0 / 3}), 3);
}

// The cubic (s - 1/4)(s - 1/2)(s - 3/4) 32 along a cell's diagonal.
TEST(ReferenceCrossings, ThreeInACell) {
  const float corner[8] = {-3, 13, 0, -13, 0, 0, 0, 3};
  const auto volume = volume_of({2, 2, 2}, [&](int i, int j, int k) { return corner[i + 2 * j + 4 * k]; });
  const auto count = [&](double v) {
    return along(scene_of(volume, surfaces_at({v})), {-1, -1, -1}, {2, 2, 2}, Answer::crossings).crossings;
  };
  EXPECT_EQ(count(0), 3);
  const double top = 2 / std::sqrt(27.0) * 32 / 64;  // of the cubic
  EXPECT_EQ(count(top * (1 - 1e-9)), 3);
  EXPECT_EQ(count(top * (1 + 1e-9)), 1);
  EXPECT_EQ(count(-top * (1 - 1e-9)), 3);
  EXPECT_EQ(count(-top * (1 + 1e-9)), 1);
}

// Along the other diagonal of a face x y is s (1 - s): it comes up to 1/4 and no further.
TEST(ReferenceCrossings, ASmoothTangentIsNone) {
  const auto volume = volume_of({2, 2, 2}, [](int i, int j, int) { return i * j; });
  const auto at = [&](double v, glm::dvec3 eye, glm::dvec3 target) {
    return along(scene_of(volume, surfaces_at({v})), eye, target, Answer::crossings);
  };
  const glm::dvec3 eye{-1, 2, 0.5}, target{2, -1, 0.5};
  EXPECT_EQ(at(0.25, eye, target).crossings, 0);
  EXPECT_TRUE(at(0.25, eye, target).grazing);
  EXPECT_EQ(at(0.25 - 1e-12, eye, target).crossings, 2);
  EXPECT_TRUE(at(0.25 - 1e-12, eye, target).grazing);
  EXPECT_EQ(at(0.24, eye, target).crossings, 2);
  EXPECT_FALSE(at(0.24, eye, target).grazing);
  EXPECT_FALSE(at(0.26, eye, target).grazing);
}

// However far from zero the field lies.
TEST(ReferenceCrossings, AnOffsetMakesNoRayGraze) {
  const double offset = 0x1p19;
  const auto volume = volume_of({2, 2, 2}, [&](int i, int j, int) { return offset + i * j; });
  const auto grazes = [&](double v) {
    return along(scene_of(volume, surfaces_at({offset + v})), {-1, 2, 0.5}, {2, -1, 0.5}, Answer::crossings)
        .grazing;
  };
  EXPECT_TRUE(grazes(0.25));
  EXPECT_FALSE(grazes(0.2499));
  EXPECT_FALSE(grazes(0.2501));
}

// Rays through the points of a lattice, on which the roots are: through vertices, edges and faces.
TEST(ReferenceCrossings, AtVerticesAndEdges) {
  const auto volume = volume_of({7, 7, 7}, [](int i, int j, int k) { return i + 2 * j + 3 * k; });
  std::vector<double> values;
  for (int v = 1; v < 36; ++v) values.push_back(v);
  const Scene scene = scene_of(volume, surfaces_at(values));
  for (const glm::dvec3 to :
       {glm::dvec3(6, 6, 6), {6, 3, 6}, {6, 6, 3}, {2, 4, 6}, {3, 3, 6}, {6, 0, 6}, {4, 6, 1}}) {
    const glm::dvec3 eye = -0.5 * to;
    const double rise = glm::dot(to, glm::dvec3(1, 2, 3));
    // Through to the end of the box: f there is met, or only reached
    const double most = rise * 6 / std::max({to.x, to.y, to.z});
    EXPECT_EQ(along(scene, eye, to, Answer::crossings).crossings, int(std::ceil(most)) - 1) << most;
    EXPECT_EQ(along(scene, 2.5 * to, glm::dvec3(0), Answer::crossings).crossings, int(std::ceil(most)) - 1)
        << most;
  }
}

TEST(ReferenceCrossings, OfPeaksOneFloatApart) {
  const float v = 4.5f;
  std::vector<double> values;
  for (float next = v; values.size() < 8; next = std::nextafter(next, 9.0f)) values.push_back(double(next));
  const Scene scene = scene_of(profile({0, 1, 2, 8}), surfaces_at(values));
  EXPECT_EQ(along(scene, {-2, 0.5, 0.5}, {1, 0.5, 0.5}, Answer::crossings).crossings, 8);
}

TEST(ReferenceCrossings, AHundredThousandOfThem) {
  std::vector<float> values(1001);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = i % 2 ? 101 : 0;
  std::vector<double> surfaces;
  for (int i = 1; i <= 100; ++i) surfaces.push_back(i);
  const Scene scene = scene_of(profile(values), surfaces_at(surfaces));
  const OneRay ray = along(scene, {-9, 0.5, 0.5}, {1, 0.5, 0.5}, Answer::crossings);
  EXPECT_EQ(ray.crossings, 100000);
  EXPECT_EQ(ray.color.a, 1);
}

TEST(ReferenceCrossings, NoneSpansAnEmptyCell) {
  const float nan = std::nanf("");
  // 0 ... 4, a hole, 4 ... 8: what lies between is not crossed
  EXPECT_EQ(crossings_of({-1, 0, 1, nan, 4, 5}, {2}), 0);
  EXPECT_EQ(crossings_of({-1, 0, 3, nan, 1, 5}, {2}), 2);
  EXPECT_EQ(crossings_of({-1, 0, 2, nan, 1, 5}, {2}), 1) << "reached where the span ends";
  EXPECT_EQ(crossings_of({-1, 0, 2, 2, INFINITY, 1, 5}, {2}), 2);
}

TEST(ReferenceCrossings, TheClipBoxBringsNewEnds) {
  Scene scene = scene_of(profile({-1, 0, 1, 2, 3, 4, 5, 6}), surfaces_at({1, 2, 3, 4, 5}));
  const auto count = [&](double from, double to) {
    scene.rendering.clip_box = ClipBox{{from, -1, -1}, {to, 2, 2}, {}};
    return along(scene, {-9, 0.5, 0.5}, {1, 0.5, 0.5}, Answer::crossings).crossings;
  };
  EXPECT_EQ(count(-1, 9), 5);
  EXPECT_EQ(count(2.5, 4.5), 2);
  EXPECT_EQ(count(3, 5), 1) << "at its faces is none";
  EXPECT_EQ(count(3.25, 3.5), 0);
  EXPECT_EQ(count(20, 30), 0) << "nothing is left";
}

}  // namespace
}  // namespace crest::testing
