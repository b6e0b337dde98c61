#include "render/volume/builtin.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "presets/error.h"
#include "render/files/load.h"
#include "render/volume/random.h"

namespace crest::test {
namespace {

glm::dvec3 random_point(Random& random) {
  const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
  return {x, y, z};
}

class EveryBuiltin : public testing::TestWithParam<std::string> {};

TEST_P(EveryBuiltin, GradientIsThatOfTheValue) {
  const FormulaField field = builtin_field(GetParam());
  constexpr double h = 1e-5;
  Random random(11);
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 p = random_point(random), gradient = field.gradient(p);
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = h;
      const auto f = [&](double t) { return field.value(p + t * step); };
      const double difference = (8 * (f(1) - f(-1)) - (f(2) - f(-2))) / (12 * h);  // of fourth order
      ASSERT_NEAR(gradient[axis], difference, 2e-6 * (1 + glm::length(gradient)))
          << fmt::format("{} {} {}", p.x, p.y, p.z);
    }
  }
}

TEST_P(EveryBuiltin, GridHoldsTheFormula) {
  const FormulaField field = builtin_field(GetParam());
  const Volume volume = make_builtin(GetParam() + "?n=17");
  EXPECT_EQ(volume.grid, (Grid{glm::ivec3(17), glm::dvec3(0.125), glm::dvec3(-1)}));
  EXPECT_EQ(volume.name, GetParam());
  for (int k = 0; k < 17; ++k) {
    for (int i = 0; i < 17; ++i) {
      const double exact = field.value({-1 + i / 8.0, 0.25, -1 + k / 8.0});
      EXPECT_EQ(volume.at(i, 10, k), float(exact));
    }
  }
}

TEST_P(EveryBuiltin, IsTheSameOnOneThread) {
  const Volume many = make_builtin(GetParam() + "?n=24");
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Volume single = load_volume("builtin:" + GetParam() + "?n=24");
  EXPECT_EQ(single.values, many.values);
  EXPECT_EQ(single.statistics.mean, many.statistics.mean);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Builtin& builtin : builtins()) all.emplace_back(builtin.name);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Volume, EveryBuiltin, testing::ValuesIn(names()), [](const auto& builtin) {
  std::string name = builtin.param;
  std::erase(name, '-');
  return name;
});

/// The grid's own interpolation between its points, in double.
double interpolate(const Volume& volume, glm::dvec3 p) {
  const glm::dvec3 t = (p - volume.grid.origin) / volume.grid.spacing;
  const glm::ivec3 cell = glm::min(glm::ivec3(t), volume.grid.dims - 2);
  const glm::dvec3 f = t - glm::dvec3(cell);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
    sum += (i ? f.x : 1 - f.x) * (j ? f.y : 1 - f.y) * (k ? f.z : 1 - f.z) *
           double(volume.at(cell.x + i, cell.y + j, cell.z + k));
  }
  return sum;
}

TEST(Builtin, LinearAndTrilinearAreExactBetweenTheirPoints) {
  Random random(5);
  for (const std::string name : {"linear", "trilinear"}) {
    const Volume volume = make_builtin(name);
    EXPECT_EQ(volume.grid.spacing, glm::dvec3(1.0 / 32));
    const FormulaField field = builtin_field(name);
    for (int i = 0; i < 5000; ++i) {
      const glm::dvec3 p = random_point(random);
      ASSERT_NEAR(interpolate(volume, p), field.value(p), 1e-14) << name;
    }
  }
}

TEST(Builtin, MarschnerLobbIsAsPublished) {
  const FormulaField field = builtin_field("marschner-lobb");
  const double pi = std::acos(-1), x = 0.3, y = -0.4, z = 0.2;
  const double rho = std::cos(2 * pi * 6 * std::cos(pi * 0.5 / 2));
  EXPECT_NEAR(field.value({x, y, z}), (1 - std::sin(pi * z / 2) + 0.25 * (1 + rho)) / (2 * 1.25), 1e-14);
  EXPECT_EQ(field.gradient({0, 0, 1}).x, 0);
}

TEST(Builtin, SphereIsADistance) {
  const FormulaField field = builtin_field("sphere?radius=0.75");
  EXPECT_DOUBLE_EQ(field.value({0, 0, 0.5}), 0.25);
  EXPECT_EQ(field.gradient({0, -0.5, 0}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(field.gradient({0, 0, 0}), glm::dvec3(0));
}

TEST(Builtin, PlumeSpansItsDecades) {
  const Volume volume = make_builtin("plume?n=64&decades=5");
  EXPECT_NEAR(std::log10(volume.statistics.range.min), -5, 0.01);
  EXPECT_GT(volume.statistics.range.max, 0.9);
  EXPECT_LE(volume.statistics.range.max, 1);
  int filled = 0;  // decades that hold at least a hundredth of the points
  for (int decade = 0; decade < 5; ++decade) {
    const auto count = histogram_of(volume.values, {std::pow(10, -decade - 1), std::pow(10, -decade)}, 1)[0];
    filled += count > volume.values.size() / 100;
  }
  EXPECT_EQ(filled, 5);
}

TEST(Builtin, VesselsAreThinBrightAndInEmptySpace) {
  for (const int seed : {1, 2, 3, 4, 5}) {
    const Volume volume = make_builtin(fmt::format("vessels?n=128&seed={}", seed));
    const auto empty =
        double(std::ranges::count(volume.values.to_floats(), 0.f)) / double(volume.values.size());
    EXPECT_GT(empty, 0.97);
    EXPECT_LT(empty, 0.995);
    EXPECT_GT(volume.statistics.range.max, 0.95);
  }
}

TEST(Builtin, NoiseIsWithinItsBand) {
  // Sampled far above twice its highest frequency, it has no power beyond it: compare a Fourier sum of a
  // windowed line inside the band and outside.
  const FormulaField field = builtin_field("noise?low=2&high=4");
  const auto power = [&](double frequency) {
    constexpr int samples = 4000;
    double re = 0, im = 0;
    for (int i = 0; i < samples; ++i) {
      const double t = (i + 0.5) / samples, window = std::pow(std::sin(std::acos(-1) * t), 4);
      const double x = 20 * t, phase = 2 * std::acos(-1) * frequency * x;
      re += window * field.value({x, 0, 0}) * std::cos(phase) / samples;
      im += window * field.value({x, 0, 0}) * std::sin(phase) / samples;
    }
    return re * re + im * im;
  };
  double inside = 0, outside = 0;
  for (double f = 0.2; f < 4; f += 0.2) inside = std::max(inside, power(f));
  for (double f = 4.5; f < 12; f += 0.2) outside = std::max(outside, power(f));
  EXPECT_GT(inside, 1e-3);
  EXPECT_LT(outside, 1e-6 * inside);
}

TEST(Builtin, SeedsDiffer) {
  for (const std::string name : {"plume", "vessels", "noise"}) {
    EXPECT_NE(make_builtin(name + "?n=16&seed=1").values, make_builtin(name + "?n=16&seed=2").values) << name;
  }
}

TEST(Builtin, WrongNamesAndParametersAreSaid) {
  const auto message = [](const std::string& source, std::uint64_t memory = 1u << 30) -> std::string {
    try {
      load_volume(source, {.memory = memory});
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(message("builtin:cube").find("marschner-lobb"), std::string::npos);
  EXPECT_NE(message("builtin:").find("marschner-lobb"), std::string::npos);
  EXPECT_NE(message("builtin:sphere?seed=1").find("\"seed\""), std::string::npos);
  EXPECT_NE(message("builtin:sphere?n=1").find("n=1"), std::string::npos);
  EXPECT_NE(message("builtin:sphere?n=x").find("n=x"), std::string::npos);
  EXPECT_NE(message("builtin:sphere?radius=nan").find("radius=nan"), std::string::npos);
  EXPECT_NE(message("builtin:sphere?n").find("key=value"), std::string::npos);
  const std::string large = message("builtin:sphere?n=1000", 3'000'000'000);
  EXPECT_NE(large.find("4 GB"), std::string::npos) << large;
  EXPECT_NE(large.find("3 GB"), std::string::npos) << large;
  EXPECT_NE(message("builtin:sphere?n=1048576"), "");
}

}  // namespace
}  // namespace crest::test
