#include "render/reference/exact_ray.h"

#include <gtest/gtest.h>

#include "render/volume/builtin.h"
#include "tests/reference/rays.h"

namespace crest::testing {
namespace {

constexpr glm::ivec2 size{12, 9};

TransferFunction spike_and_haze() {
  return tf_of({{0, 0}, {0.3, 0.1}, {0.39, 0.05}, {0.4, 0.7}, {0.41, 0.05}, {1, 0.3}});
}

// Collected to the end, a ray is the picture's pixel; on the way opacity never falls, nor does depth.
TEST(ExactRay, EndsAsThePictureDoes) {
  for (const auto& [name, projection] : {std::pair{"gyroid?n=12", Projection::perspective},
                                         {"noise?n=10", Projection::perspective},
                                         {"gyroid?n=12", Projection::parallel}}) {
    const auto volume = std::make_shared<const Volume>(make_builtin(name));
    Scene scene{volume, resolve(spike_and_haze(), volume->statistics.range, 1), {}};
    const Camera camera = whole_volume_camera(volume->grid, aspect_of(size), 30, projection);
    for (const Answer answer :
         {Answer::integral, Answer::crossings, Answer::integral_and_crossings, Answer::base_and_crossings}) {
      const Reference picture = render_reference(scene, camera, size, answer);
      const ExactRays rays(scene, camera, size, answer);
      int met = 0;
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const ExactRay ray = rays.at({x, y});
          const std::size_t pixel = std::size_t(y * size.x + x);
          if (ray.places.empty()) {
            EXPECT_EQ(picture.pixels[pixel].a, 0);
            continue;
          }
          EXPECT_NEAR(ray.places.back().opacity, picture.pixels[pixel].a, 1e-8);
          EXPECT_NEAR(ray.places.back().color.r, picture.pixels[pixel].r, 1e-8);
          EXPECT_NEAR(ray.places.front().depth, ray.enter, 1e-9);
          EXPECT_NEAR(ray.places.back().depth, ray.exit, 1e-9);
          int crossings = 0;
          for (std::size_t i = 1; i < ray.places.size(); ++i) {
            EXPECT_GE(ray.places[i].depth, ray.places[i - 1].depth);
            EXPECT_GE(ray.places[i].opacity, ray.places[i - 1].opacity - 1e-12);
            if (!ray.places[i].surface) continue;
            EXPECT_NEAR(ray.places[i].value, *ray.places[i].surface, 1e-9)
                << "the field is at the surface's value";
            ++crossings;
          }
          EXPECT_EQ(crossings, int(picture.crossings[pixel]));
          met += crossings;
        }
      EXPECT_EQ(met > 0, answer != Answer::integral);
    }
  }
}

// Along x the values 0 .. 4 rise by 1 a voxel: depth tells the value.
TEST(ExactRay, TellsDepthsAndValues) {
  const auto volume = profile({0, 1, 2, 3, 4});
  Scene scene = scene_of(volume, tf_of({{0, 0}, {2.4, 0}, {2.5, 0.8}, {2.6, 0}, {4, 0}}));
  const ExactRays rays(scene, one_ray({-10, 0.5, 0.5}, {0, 0.5, 0.5}), {1, 1}, Answer::crossings);
  const ExactRay ray = rays.at({0, 0});
  EXPECT_NEAR(ray.enter, 10, 1e-9);
  EXPECT_NEAR(ray.exit, 14, 1e-9);
  for (const double depth : {10.0, 10.3, 12.7, 14.0}) EXPECT_NEAR(ray.value_at(depth), depth - 10, 1e-6);
  EXPECT_EQ(ray.opacity_at(12.49), 0);
  EXPECT_NEAR(ray.opacity_at(12.51), 0.8, 1e-12);
  const Picked picked = pick(ray);
  ASSERT_TRUE(picked.surface && picked.strongest);
  EXPECT_NEAR(*picked.surface, 2.5, 1e-12);
  EXPECT_NEAR(*picked.surface_depth, 12.5, 1e-6);
  EXPECT_NEAR(*picked.strongest, 2.5, 1e-12);
  EXPECT_NEAR(picked.strongest_share, 1, 1e-12);
}

// A wide bump that is denser at 3 than anywhere else: without a surface the strongest value is near there.
TEST(ExactRay, PicksTheStrongestValueWhereThereIsNoSurface) {
  const auto volume = profile({0, 1, 2, 3, 4});
  Scene scene = scene_of(volume, tf_of({{0, 0}, {2, 0.01}, {3, 0.2}, {4, 0.01}}));
  const ExactRays rays(scene, one_ray({-10, 0.5, 0.5}, {0, 0.5, 0.5}), {1, 1}, Answer::integral);
  const Picked picked = pick(rays.at({0, 0}));
  EXPECT_FALSE(picked.surface);
  ASSERT_TRUE(picked.strongest);
  EXPECT_NEAR(*picked.strongest, 3, 0.1);
  EXPECT_FALSE(pick(rays.at({0, 0})).surface);
  const ExactRays beside(scene, one_ray({-10, 5, 0.5}, {0, 5, 0.5}), {1, 1}, Answer::integral);
  EXPECT_TRUE(beside.at({0, 0}).places.empty());
  EXPECT_FALSE(pick(beside.at({0, 0})).strongest);
}

}  // namespace
}  // namespace crest::testing
