#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/classify/classification.h"
#include "tests/raycaster/brute_force.h"
#include "tests/reference/rays.h"

// The same answers by sampling, very finely.
namespace crest::testing {
namespace {

/// Midpoint sums: no knowledge of cells, cubics or control points. Surfaces where neighbouring samples are on
/// different sides.
struct Sampled {
  glm::dvec4 color{0};
  int crossings = 0;
};

template <class Field>
Sampled sample(const Field& field, const BruteRay& ray, const TransferFunction& tf, double smallest_spacing,
               const std::vector<Peak>& surfaces, int n) {
  Sampled result;
  double transmittance = 1, before = 0;
  const auto collect = [&](glm::dvec3 color, double alpha) {
    result.color += transmittance * alpha * glm::dvec4(color, 1);
    transmittance *= 1 - alpha;
  };
  const double dt = (ray.exit - ray.enter) / n;
  for (int i = 0; i < n && ray.hits(); ++i) {
    const double f = field(ray.origin + (ray.enter + (i + 0.5) * dt) * ray.direction);
    for (std::size_t k = 0; i > 0 && k < surfaces.size(); ++k) {
      const Peak& peak = surfaces[f > before ? k : surfaces.size() - 1 - k];
      if ((before >= peak.value) == (f >= peak.value)) continue;
      collect(peak.color, peak.opacity);
      ++result.crossings;
    }
    const Classified at = evaluate(tf, f);
    collect(at.color, -std::expm1(-extinction(at.opacity, tf.unit_distance) * smallest_spacing * dt));
    before = f;
  }
  return result;
}

constexpr Answer all_answers[] = {Answer::integral, Answer::crossings, Answer::integral_and_crossings,
                                  Answer::base_and_crossings};

template <class Render, class Field>
void expect_as_sampled(const Scene& scene, const Camera& camera, glm::ivec2 size, int n, double tolerance,
                       const Render& render, const Field& field) {
  const Classification classified = classify(scene.tf, scene.volume->statistics.range);
  for (const Answer answer : all_answers) {
    TransferFunction tf = scene.tf;
    if (answer == Answer::crossings) tf.points.clear();
    if (answer == Answer::base_and_crossings) tf = base_transfer_function(tf, classified.peaks);
    const auto surfaces = answer == Answer::integral ? std::vector<Peak>{} : classified.surfaces;
    const Reference picture = render(answer);
    double worst = 0;
    int miscounted = 0;
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x) {
        const std::size_t index = std::size_t(y * size.x + x);
        const Sampled found = sample(field, brute_ray(camera, scene.volume->grid, size, x, y), tf,
                                     scene.volume->grid.smallest_spacing(), surfaces, n);
        if (int(picture.crossings[index]) !=
            found.crossings) {  // both sides of a tangent fell between samples
          ++miscounted;
          EXPECT_GT(picture.crossings[index], found.crossings);
          continue;
        }
        const glm::dvec4 off = glm::abs(picture.pixels[index] - found.color);
        worst = std::max({worst, off.r, off.g, off.b, off.a});
      }
    EXPECT_LT(worst, tolerance) << name_of(answer);
    EXPECT_LE(miscounted, size.x * size.y / 50) << name_of(answer);
  }
}

TEST(ReferenceBruteForce, RandomVolumesAndTransferFunctions) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  for (int round = 0; round < 12; ++round) {
    const auto volume =
        volume_of({4, 5, 3}, [&](int, int, int) { return random() % 4 ? unit(random) : 0.5f; }, {1, 0.5, 2},
                  {-3, 10, 0.25});
    TransferFunction tf = random_tf(random, 9);
    tf.unit_distance = 0.5;
    const Scene scene = scene_of(volume, tf);
    const Camera camera = whole_volume_camera(volume->grid, 1, 40);
    const glm::ivec2 size(6, 6);
    expect_as_sampled(
        scene, camera, size, 10000, 2e-3, [&](Answer a) { return render_reference(scene, camera, size, a); },
        [&](glm::dvec3 p) { return trilinear(*volume, p); });
  }
}

TEST(ReferenceBruteForce, AFormula) {
  std::mt19937 random(3);
  for (const char* name : {"marschner-lobb?n=16", "gyroid?n=8", "vessels?n=32", "noise?n=16"}) {
    const auto volume = std::make_shared<const Volume>(make_builtin(name));
    const FormulaField field = builtin_field(name);
    TransferFunction tf = resolve(random_tf(random, 6), volume->statistics.range, 1);
    tf.domain = Domain::normalized;
    const Scene scene = scene_of(volume, resolve(tf, volume->statistics.range, 1));
    const Camera camera = whole_volume_camera(volume->grid, 1, 40);
    const glm::ivec2 size(4, 4);
    expect_as_sampled(
        scene, camera, size, 10000, 2e-3,
        [&](Answer a) { return render_reference(field, scene, camera, size, a); },
        [&](glm::dvec3 p) { return field.value(volume->grid.origin + volume->grid.smallest_spacing() * p); });
  }
}

}  // namespace
}  // namespace crest::testing
