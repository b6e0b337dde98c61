#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "render/scene/camera.h"
#include "tests/reference/rays.h"

// Formulas have solutions of their own, or are the trilinear field itself.
namespace crest::testing {
namespace {

constexpr Answer all_answers[] = {Answer::integral, Answer::crossings, Answer::integral_and_crossings,
                                  Answer::base_and_crossings};

double largest_difference(const Reference& a, const Reference& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int channel = 0; channel < 4; ++channel)
      most = std::max(most, std::abs(a.pixels[i][channel] - b.pixels[i][channel]));
  return most;
}

// At n=65 these formulas and the field between their samples are the same.
TEST(ReferenceFormula, IsTheTrilinearFieldWhereThisIsExact) {
  std::mt19937 random(5);
  const glm::ivec2 size(12, 10);
  std::uint32_t crossings = 0;
  for (const char* name : {"linear?n=65", "trilinear?n=65"}) {
    const auto volume = std::make_shared<const Volume>(make_builtin(name));
    const FormulaField field = builtin_field(name);
    const Camera camera = whole_volume_camera(volume->grid, 1, 40);
    for (int round = 0; round < 4; ++round) {
      TransferFunction tf = random_tf(random, 8);
      tf.domain = Domain::normalized;
      const Scene scene = scene_of(volume, resolve(tf, volume->statistics.range, 1));
      for (const Answer answer : all_answers) {
        const Reference of_formula = render_reference(field, scene, camera, size, answer),
                        of_cells = render_reference(scene, camera, size, answer);
        EXPECT_LT(largest_difference(of_formula, of_cells), 1e-9) << name << " " << name_of(answer);
        EXPECT_EQ(of_formula.crossings, of_cells.crossings) << name << " " << name_of(answer);
        for (const std::uint32_t count : of_cells.crossings) crossings += count;
      }
    }
  }
  EXPECT_GT(crossings, 100u);
}

/// A formula over the box of a volume that says nothing about it.
struct FormulaScene {
  FormulaField field;
  Scene scene;

  OneRay along(glm::dvec3 eye, glm::dvec3 target, Answer answer) const {
    const Reference picture = render_reference(field, scene, one_ray(eye, target), {1, 1}, answer);
    return {picture.pixels[0], int(picture.crossings[0]), picture.grazing[0] != 0};
  }
};

FormulaScene formula_scene(std::function<double(glm::dvec3)> value, TransferFunction tf, double sample = 1) {
  const auto gradient = [value](glm::dvec3 p) {
    const double h = 1e-5;
    const auto slope = [&](glm::dvec3 d) { return (value(p + h * d) - value(p - h * d)) / (2 * h); };
    return glm::dvec3(slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1}));
  };
  const auto volume = volume_of(
      {5, 5, 5}, [&](int, int, int) { return sample; }, glm::dvec3(0.5),
      glm::dvec3(-1));  // over [-1, 1]^3
  return {{value, gradient}, scene_of(volume, std::move(tf))};
}

// Through the middle of a ball the distance from it is |t|, with a kink; past the middle it is a hyperbola.
TEST(ReferenceFormula, ADistanceAndItsKink) {
  TransferFunction tf = tf_of({{0, 0.8}, {1, 0.2}});
  tf.unit_distance = 0.5;
  const FormulaScene ball = formula_scene([](glm::dvec3 p) { return glm::length(p); }, tf);
  // 2 * integral of -ln(1 - 0.8 + 0.6 r) dr, r from 0 to 1
  const auto primitive = [](double u) { return u * std::log(u) - u; };
  const double depth = -2 * (primitive(0.8) - primitive(0.2)) / 0.6 / tf.unit_distance;
  EXPECT_NEAR(ball.along({-3, 0, 0}, {0, 0, 0}, Answer::integral).color.a, -std::expm1(-depth), 1e-10);
}

// Surfaces of a field that oscillates 100 times on the ray: two crossings a period.
TEST(ReferenceFormula, CrossingsOfAWave) {
  TransferFunction tf = tf_of({{-2, 0}, {0.5, 0}, {0.5, 0.01}, {0.5, 0}, {2, 0}});
  const FormulaScene wave =
      formula_scene([](glm::dvec3 p) { return std::sin(100 * std::numbers::pi * p.x); }, tf);
  const OneRay ray = wave.along({-3, 0.1, 0.2}, {0, 0.1, 0.2}, Answer::crossings);
  EXPECT_EQ(ray.crossings, 200);
  EXPECT_NEAR(ray.color.a, 1 - std::pow(0.99, 200), 1e-12);
}

// The samples know nothing of the values that the formula reaches between them.
TEST(ReferenceFormula, SurfacesBeyondTheSampledValues) {
  TransferFunction tf = tf_of({{-9, 0}, {5, 0}, {5, 0.5}, {5, 0}, {9, 0}});
  const auto value = [](glm::dvec3 p) { return 8 - 8 * glm::dot(p, p); };
  for (const double sample : {0.0, 1.0}) {
    const FormulaScene ball = formula_scene(value, tf, sample);
    EXPECT_EQ(ball.along({-3, 0.1, 0.2}, {0, 0.1, 0.2}, Answer::crossings).crossings, 2) << sample;
    EXPECT_EQ(along(ball.scene, {-3, 0.1, 0.2}, {0, 0.1, 0.2}, Answer::crossings).crossings, 0) << sample;
  }
}

}  // namespace
}  // namespace crest::testing
