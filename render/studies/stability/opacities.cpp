#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/scene/float_precision.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/haze_and_plane.h"

// How much a material absorbs, from next to nothing to all, over steps from long to short.

namespace crest::stability {
namespace {

/// A slab of one material, seen head on: the opacity of `length` of it.
double slab_opacity(double opacity, double unit_distance, double length) {
  return -std::expm1(-extinction(opacity, unit_distance) * length);
}

std::vector<glm::dvec4> gray(glm::ivec2 size, double opacity) {
  return std::vector(std::size_t(size.x) * std::size_t(size.y), glm::dvec4(opacity));
}

constexpr glm::ivec2 small{16, 16};

}  // namespace

std::vector<Row> faint_and_opaque_haze(Lab& lab) {
  std::vector<Row> rows;
  const VolumePtr volume = make_volume(cube(9), [](glm::dvec3) { return 0.5; });
  for (const double opacity : {1e-7, 1 - 1e-7, 1.0}) {
    Worst worst;
    std::vector<Image> pictures;
    for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
      const Scene scene = make_scene(volume, make_tf({point(0, opacity), point(1, opacity)}, 2), mode);
      pictures.push_back(lab.draw(scene, along_z(volume->grid, 6), small));
      worst.take(largest_relative_difference(pictures.back(), gray(small, slab_opacity(opacity, 2, 8))),
                 crest::name_of(mode));
    }
    rows.push_back(judge({.name = fmt::format("haze of opacity {}", opacity),
                          .quantity = "relative error of a channel, through 4 unit distances",
                          .bound = 1e-5},
                         worst, pictures));
  }
  return rows;
}

std::vector<Row> faint_and_opaque_surfaces(Lab& lab) {
  std::vector<Row> rows;
  const VolumePtr volume = make_volume(cube(17), [](glm::dvec3 p) { return p.z / 16; });
  for (const double opacity : {1e-7, 1 - 1e-7, 1.0}) {
    Worst worst;
    std::vector<Image> pictures;
    for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
      // A white surface, and behind it one that is seen only through it
      TransferFunction tf = peaks_at({0.4, 0.6}, opacity);
      tf.points[4].color = {1, 0, 0};
      tf.points[4].surface.opacity = 0.5;
      const Scene scene = make_scene(volume, tf, mode);
      pictures.push_back(lab.draw(scene, along_z(volume->grid, 8), small));
      const double behind = (1 - opacity) * 0.5;
      const std::vector truth(small.x * small.y,
                              glm::dvec4(opacity + behind, opacity, opacity, opacity + behind));
      worst.take(largest_relative_difference(pictures.back(), truth), crest::name_of(mode));
    }
    rows.push_back(judge({.name = fmt::format("a surface of opacity {}, another behind it", opacity),
                          .quantity = "relative error of a channel",
                          .bound = 1e-6},
                         worst, pictures));
  }
  return rows;
}

std::vector<Row> extinction_times_step(Lab& lab) {
  std::vector<Row> rows;
  const VolumePtr constant = make_volume(cube(9), [](glm::dvec3) { return 0.5; });
  const double step = 1;
  for (const double product : {1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9}) {
    Worst worst;
    std::vector<Image> pictures;
    const double opacity = product < 1 ? 1e-3 : 0.999;
    const double unit_distance = extinction(opacity, 1) * step / product;
    for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
      const Scene scene =
          make_scene(constant, make_tf({point(0, opacity), point(1, opacity)}, unit_distance), mode, step);
      pictures.push_back(lab.draw(scene, along_z(constant->grid, 6), small));
      worst.take(largest_relative_difference(pictures.back(), gray(small, -std::expm1(-product * 8 / step))),
                 crest::name_of(mode));
      // The same around a surface, which cuts a step
      const HazeAndPlane haze{
          .grid = cube(9), .weights = {0, 0, 1}, .haze_opacity = opacity, .unit_distance = unit_distance};
      const Camera camera = along_z(haze.grid, 6);
      pictures.push_back(lab.draw(scene_of(haze, mode, step), camera, small));
      worst.take(largest_difference(pictures.back(), truth_of(haze, mode, camera, small)),
                 fmt::format("{}, with a surface", crest::name_of(mode)));
    }
    rows.push_back(judge({.name = fmt::format("extinction times step of {:g}", product),
                          .quantity = "error of a channel: relative of haze alone, absolute with a surface",
                          .bound = 1e-5},
                         worst, pictures));
  }
  return rows;
}

std::vector<Row> surface_in_dense_haze(Lab& lab) {
  // A surface one mean free path behind the face at which the rays enter: it is seen through 1/e of haze
  constexpr glm::ivec2 many{256, 256};  // the worst is at few pixels
  std::vector<Row> rows;
  for (const double extinction_per_voxel : {1.0, 1e1, 1e2, 1e3, 1e4}) {
    HazeAndPlane haze{.grid = cube(9), .weights = {0, 0, 1}, .haze_opacity = 0.999};
    haze.isovalue_share = 1 / (8 * extinction_per_voxel);
    haze.unit_distance = extinction(haze.haze_opacity, 1) / extinction_per_voxel;
    Camera camera = whole_volume_camera(haze.grid, 1);
    camera.eye.z = 2 * camera.target.z - camera.eye.z;  // from below
    Worst worst;
    std::vector<Image> pictures;
    for (const Mode mode : {Mode::peak_xor_dvr, Mode::both}) {
      pictures.push_back(lab.draw(scene_of(haze, mode), camera, many));
      worst.take(largest_difference(pictures.back(), truth_of(haze, mode, camera, many)),
                 crest::name_of(mode));
    }
    // How much of the rounding of positions a picture meets depends on the view: what holds for all views is
    // haze_rounding(), of which a person is told where it would be seen
    const Scene scene = scene_of(haze, Mode::both);
    auto warnings = scene_warnings(scene, camera, many);
    Claim claim{.name = fmt::format("a surface one mean free path inside haze of extinction {:g} a voxel",
                                    extinction_per_voxel),
                .quantity = "largest error of a channel",
                .bound = warnings.empty() ? std::max(1e-3, haze_rounding(scene)) : 1e-3};
    if (!warnings.empty())
      claim.limit = {haze_rounding(scene), "positions are rounded to 2^-24 of the box's diagonal",
                     std::move(warnings)};
    rows.push_back(judge(std::move(claim), worst, pictures));
  }
  return rows;
}

std::vector<Row> beyond_all_opacity(Lab& lab) {
  Worst worst;
  std::vector<Image> pictures;
  for (const double unit_distance : {1e-40, 1e-300})
    for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
      HazeAndPlane haze;
      haze.unit_distance = unit_distance;
      const Camera camera = whole_volume_camera(haze.grid, 1);
      pictures.push_back(lab.draw(scene_of(haze, mode), camera));
      // The box is solid: alpha is 1 where a ray meets it, or 0
      worst.take(largest_difference(pictures.back(), truth_of(haze, mode, camera, lab.size)),
                 fmt::format("unit distance {}, {}", unit_distance, crest::name_of(mode)));
    }
  return {judge({.name = "unit distance of 1e-40 and less",
                 .quantity = "largest error of a channel, of a box that is solid",
                 .bound = 1e-6},
                worst, pictures)};
}

std::vector<Row> hundred_thousand_crossings(Lab& lab) {
  // A zigzag of 100 flanks through 1000 peaks
  constexpr glm::ivec2 size{2, 2};
  constexpr double opacity = 1e-5;
  Grid grid{{2, 2, 101}, glm::dvec3(1), glm::dvec3(0)};
  const VolumePtr volume = make_volume(grid, [](glm::dvec3 p) { return std::lround(p.z) % 2; });
  std::vector<double> values;
  for (int i = 0; i < 1000; ++i) values.push_back((i + 0.5) / 1000);
  std::vector<Row> rows;
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    Scene scene = make_scene(volume, peaks_at(values, opacity, 1e-4), mode, 0.05);
    const CountedPicture picture = draw_counted(lab, scene, along_z(grid, 0.9), size);
    Worst relative, count;
    relative.take(
        largest_relative_difference(picture.image, gray(size, -std::expm1(1e5 * std::log1p(-opacity)))), "");
    rows.push_back(judge({.name = fmt::format("1e5 crossings of opacity 1e-5, {}", crest::name_of(mode)),
                          .quantity = "relative error of a channel",
                          .bound = 1e-5},
                         relative, {&picture.image, 1}));
    for (const unsigned crossings : picture.crossings) count.take(std::abs(double(crossings) - 1e5), "");
    rows.push_back(judge({.name = fmt::format("1e5 crossings of opacity 1e-5, {}", crest::name_of(mode)),
                          .quantity = "crossings missed or invented, of 1e5 a ray",
                          .bound = 0},
                         count, {&picture.image, 1}));
  }
  return rows;
}

std::vector<Row> steps_long_and_short(Lab& lab) {
  std::vector<Row> rows;
  const HazeAndPlane haze{.grid = cube(9)};
  const Camera camera = whole_volume_camera(haze.grid, 1);
  for (const double step : {8.0, 2.0, 0.5, 1.0 / 8, 1.0 / 32, 1.0 / 256}) {
    Worst worst;
    std::vector<Image> pictures;
    for (const Mode mode : tested_modes) {
      pictures.push_back(lab.draw(scene_of(haze, mode, step), camera));
      worst.take(largest_difference(pictures.back(), truth_of(haze, mode, camera, lab.size)),
                 crest::name_of(mode));
    }
    rows.push_back(judge({.name = fmt::format("step of {:g} voxels", step),
                          .quantity = "largest error of a channel, haze with a surface in it",
                          .bound = 1e-5},
                         worst, pictures));
  }
  return rows;
}

}  // namespace crest::stability
