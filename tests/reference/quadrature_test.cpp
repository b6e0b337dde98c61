#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <random>

#include "render/classify/classification.h"
#include "tests/raycaster/brute_force.h"
#include "tests/reference/rays.h"

// The same answers by another way that is as exact, and slow: the ray is cut where anything bends, by
// bisection, and each piece integrated on panels that get ever shorter towards its ends.
namespace crest::testing {
namespace {

using Gauss = boost::math::quadrature::gauss<double, 10>;

class SlowRay {
 public:
  /// `surfaces` by ascending value.
  SlowRay(const Volume& volume, const TransferFunction& tf, const std::vector<Peak>& surfaces,
          const BruteRay& ray)
      : volume_(volume), tf_(tf), surfaces_(surfaces), ray_(ray) {
    for (std::size_t i = 0; i < tf.points.size(); ++i) {
      bends_.push_back(tf.points[i].value);
      if (i > 0) add_cap(tf.points[i - 1], tf.points[i]);
    }
    for (const Peak& peak : surfaces) bends_.push_back(peak.value);
    std::ranges::sort(bends_);
    bends_.erase(std::unique(bends_.begin(), bends_.end()), bends_.end());
    if (!ray.hits()) return;
    const std::vector<double> faces = places_of_faces();
    for (std::size_t i = 1; i < faces.size(); ++i) add_cell(faces[i - 1], faces[i]);
  }

  glm::dvec4 color() const { return color_; }
  int crossings() const { return crossings_; }

 private:
  double field(double t) const { return trilinear(volume_, ray_.origin + t * ray_.direction); }
  double depth_slope(double t) const {
    return extinction(evaluate(tf_, field(t)).opacity, tf_.unit_distance) * volume_.grid.smallest_spacing();
  }

  /// The value between two points at which the opacity's cap begins, or ends.
  void add_cap(const ControlPoint& a, const ControlPoint& b) {
    const double cap = 1 - least_transmittance;
    if ((a.opacity > cap) != (b.opacity > cap))
      bends_.push_back(a.value + (b.value - a.value) * (cap - a.opacity) / (b.opacity - a.opacity));
  }

  std::vector<double> places_of_faces() const {
    std::vector<double> places{ray_.enter, ray_.exit};
    const glm::dvec3 cell = volume_.grid.spacing / volume_.grid.smallest_spacing();
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 1; i + 1 < volume_.grid.dims[axis]; ++i) {
        const double t = (i * cell[axis] - ray_.origin[axis]) / ray_.direction[axis];
        if (t > ray_.enter && t < ray_.exit) places.push_back(t);
      }
    std::ranges::sort(places);
    return places;
  }

  /// In a cell the field is the cubic through four of its values: its extrema are roots of a quadratic.
  void add_cell(double from, double to) {
    const double h = (to - from) / 3;
    const double f0 = field(from), f1 = field(from + h), f2 = field(from + 2 * h), f3 = field(to);
    const double a = 1.5 * (f3 - 3 * f2 + 3 * f1 - f0), b = 2 * f0 - 5 * f1 + 4 * f2 - f3,
                 c = (-11 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 6;
    std::vector<double> ends{from, to};
    const double root = std::sqrt(std::max(b * b - 2 * a * c, 0.0));
    for (const double x : {(-b - root) / a, (-b + root) / a})
      if (x > 0 && x < 3) ends.push_back(from + x * h);
    std::ranges::sort(ends);
    for (std::size_t i = 1; i < ends.size(); ++i) add_monotone(ends[i - 1], ends[i]);
  }

  void add_monotone(double from, double to) {
    const double first = field(from), last = field(to);
    const bool rises = last > first;
    std::vector<double> met;
    for (const double v : bends_)
      if (v > std::min(first, last) && v < std::max(first, last)) met.push_back(v);
    if (!rises) std::ranges::reverse(met);
    for (const double v : met) {
      double low = from, high = to;
      for (int i = 0; i < 60; ++i) {
        const double middle = std::midpoint(low, high);
        ((field(middle) < v) == rises ? low : high) = middle;
      }
      add_smooth(from, low);
      cross(v, rises);
      from = low;
    }
    add_smooth(from, to);
  }

  /// Panels whose lengths halve towards both ends, where an opacity of 1 has a singularity.
  void add_smooth(double from, double to) {
    constexpr int halvings = 24;
    const double half = (to - from) / 2;
    double length = half * std::pow(0.5, halvings), begin = from;
    for (int i = 0; i <= halvings; ++i) {
      const double end = from + half * std::pow(0.5, halvings - i);
      add_panel(begin, end);
      begin = end;
    }
    for (int i = 1; i <= halvings; ++i) {
      const double end = to - half * std::pow(0.5, i);
      add_panel(begin, end);
      begin = end;
    }
    add_panel(to - length, to);
  }

  void add_panel(double from, double to) {
    if (!(to > from) || transmittance_ < 1e-18) return;
    const auto depth = [&](double t) {
      return Gauss::integrate([&](double x) { return depth_slope(x); }, from, t);
    };
    const double whole = depth(to);
    if (whole > 1) {
      add_panel(from, std::midpoint(from, to));
      return add_panel(std::midpoint(from, to), to);
    }
    for (int channel = 0; whole > 0 && channel < 3; ++channel)
      color_[channel] += transmittance_ * Gauss::integrate(
                                              [&](double t) {
                                                return evaluate(tf_, field(t)).color[channel] *
                                                       depth_slope(t) * std::exp(-depth(t));
                                              },
                                              from, to);
    color_.a -= transmittance_ * std::expm1(-whole);
    transmittance_ *= std::exp(-whole);
  }

  void cross(double value, bool rises) {
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      const Peak& peak = surfaces_[rises ? i : surfaces_.size() - 1 - i];
      if (peak.value != value) continue;
      color_ += transmittance_ * peak.opacity * glm::dvec4(peak.color, 1);
      transmittance_ *= 1 - peak.opacity;
      ++crossings_;
    }
  }

  const Volume& volume_;
  const TransferFunction& tf_;
  const std::vector<Peak>& surfaces_;
  const BruteRay& ray_;
  std::vector<double> bends_;
  double transmittance_ = 1;
  glm::dvec4 color_{0};
  int crossings_ = 0;
};

TEST(ReferenceQuadrature, RandomVolumesAndTransferFunctions) {
  constexpr Answer all_answers[] = {Answer::integral, Answer::crossings, Answer::integral_and_crossings,
                                    Answer::base_and_crossings};
  std::mt19937 random(17);
  std::uniform_real_distribution<float> unit(0, 1);
  const glm::ivec2 size(2, 2);
  int crossings = 0;
  double most_light = 0;
  for (int round = 0; round < 24; ++round) {
    const auto volume =
        volume_of({4, 3, 3}, [&](int, int, int) { return unit(random); }, {1, 0.5, 2}, {-3, 10, 0.25});
    TransferFunction tf = random_tf(random, 9);
    tf.unit_distance = round % 3 == 0 ? 0.02 : round % 3 == 1 ? 0.5 : 40;
    const Scene scene = scene_of(volume, tf);
    Camera camera = whole_volume_camera(volume->grid, 1, 40);
    camera.fov_y_degrees = 12;
    const Classification classified = classify(tf, volume->statistics.range);
    const Answer answer = all_answers[round % 4];
    if (answer == Answer::crossings) tf.points.clear();
    if (answer == Answer::base_and_crossings) tf = classified.base;
    const auto surfaces = answer == Answer::integral ? std::vector<Peak>{} : classified.surfaces;
    const Reference picture = render_reference(scene, camera, size, answer);
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      const BruteRay ray = brute_ray(camera, volume->grid, size, int(i % 2), int(i / 2));
      const SlowRay slow(*volume, tf, surfaces, ray);
      for (int channel = 0; channel < 4; ++channel)
        EXPECT_NEAR(picture.pixels[i][channel], slow.color()[channel], 1e-11)
            << "round " << round << ", pixel " << i << ", " << name_of(answer);
      EXPECT_EQ(int(picture.crossings[i]), slow.crossings()) << "round " << round << ", pixel " << i;
      crossings += slow.crossings();
      most_light = std::max(most_light, slow.color().a);
    }
  }
  EXPECT_GT(crossings, 40);
  EXPECT_GT(most_light, 0.9);
}

}  // namespace
}  // namespace crest::testing
