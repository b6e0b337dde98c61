#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/haze_and_plane.h"
#include "render/volume/random.h"

// Crossings that are easily counted twice, or missed: their number must be exact.

namespace crest::stability {
namespace {

constexpr glm::ivec2 small{8, 8};
constexpr double steps[] = {2.0, 1.0, 0.5, 0.25, 0.3, 1.0 / 16};

Claim counted(std::string name, Truth truth = Truth::closed_form, bool empty = false) {
  return {.name = std::move(name),
          .quantity = "crossings missed or invented, at any pixel and step",
          .bound = 0,
          .truth = truth,
          .empty = empty};
}

/// A field that is `values` along z.
VolumePtr along_z_axis(const std::vector<double>& values) {
  const Grid grid{{3, 3, int(values.size())}, glm::dvec3(1), glm::dvec3(0)};
  return make_volume(grid, [&](glm::dvec3 p) { return values[std::size_t(std::lround(p.z))]; });
}

/// What a ray meets at a step of 2 on a box 8 long: the values at z = 0, 1, 3, 5, 7, 8.
struct Profile {
  std::array<double, 6> samples;
  unsigned crossings;  ///< of the value 2
};

std::vector<double> points_of(const Profile& profile) {
  const auto& s = profile.samples;
  return {s[0], s[1], (s[1] + s[2]) / 2, s[2], (s[2] + s[3]) / 2, s[3], (s[3] + s[4]) / 2, s[4], s[5]};
}

std::vector<Row> rows_of(Lab& lab, const std::string& name, const std::vector<Profile>& profiles,
                         bool empty) {
  const TransferFunction tf = peaks_at({2}, 0.25);
  Worst worst;
  std::vector<Image> pictures;
  for (const Profile& profile : profiles) {
    const VolumePtr volume = along_z_axis(points_of(profile));
    for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr})
      for (const double step : steps) {
        const CountedPicture picture =
            draw_counted(lab, make_scene(volume, tf, mode, step), along_z(volume->grid, 1.5), small);
        pictures.push_back(picture.image);
        for (const unsigned crossings : picture.crossings)
          worst.take(std::abs(double(crossings) - profile.crossings),
                     fmt::format("{}, step {:g}", fmt::join(profile.samples, " "), step));
      }
  }
  return {judge(counted(name, Truth::closed_form, empty), worst, pictures)};
}

/// Changes of side along the line through `values`: inside = {f >= v}, between parts of positive length.
unsigned crossings_of(const std::vector<double>& values, double v) {
  std::vector<bool> inside;  // of the parts, in their order
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double a = values[i - 1], b = values[i];
    if (a == v && b == v) {
      inside.push_back(true);
      continue;
    }
    if (a != v) inside.push_back(a > v);
    if (b != v) inside.push_back(b > v);
  }
  unsigned count = 0;
  for (std::size_t i = 1; i < inside.size(); ++i) count += inside[i] != inside[i - 1];
  return count;
}

/// Rays in all directions against the exact picture. A step passes over surfaces that are entered and left
/// again within it, fewer the shorter it is; it must neither invent one nor miss one of a pair.
std::vector<Row> rows_against_exact(Lab& lab, const std::string& name, const VolumePtr& volume,
                                    double isovalue, const Camera& camera) {
  std::vector<Row> rows;
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    const TransferFunction tf = haze_with_surface(volume->statistics.range, isovalue, 0.2, 0.5,
                                                  8 * volume->grid.smallest_spacing(), mode);
    Worst miscounted, missed;
    std::vector<Image> pictures;
    int left_out = 0;
    for (const double step : {0.5, 1.0 / 64}) {
      const Scene scene = make_scene(volume, tf, mode, step);
      const CountedPicture picture = draw_counted(lab, scene, camera, lab.size);
      const Deviation off = deviation_from_exact(picture, scene, camera);
      pictures.push_back(picture.image);
      miscounted.take(off.miscounted, fmt::format("step {:g}", step));
      if (step < 0.5) missed.take(double(off.missed) / double(picture.crossings.size()), "");
      left_out = std::max(left_out, off.left_out);
    }
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "pixels with a crossing invented, or missed other than in pairs",
                          .bound = 0,
                          .truth = Truth::reference},
                         miscounted, pictures, left_out));
    rows.push_back(judge({.name = fmt::format("{}, {}, step 1/64", name, crest::name_of(mode)),
                          .quantity = "crossings missed in pairs, a pixel",
                          .bound = 1e-3,
                          .truth = Truth::reference},
                         missed, pictures, left_out));
  }
  return rows;
}

Camera looking_along(glm::dvec3 direction, glm::dvec3 target, double height) {
  Camera camera;
  camera.target = target;
  camera.eye = target - 20.0 * height * glm::normalize(direction);
  camera.up = {0.3, 1, 0.1};
  camera.fov_y_degrees = 3;
  return camera;
}

}  // namespace

std::vector<Row> samples_on_the_isovalue(Lab& lab) {
  return rows_of(lab, "samples on the isovalue",
                 {{{0, 2, 3, 2, 0, 0}, 2},
                  {{4, 2, 0, 2, 4, 4}, 2},
                  {{0, 1, 3, 3, 1, 0}, 2},
                  {{4, 3, 2, 1, 0, 0}, 1},
                  {{0, 1, 2, 3, 2, 1}, 2}},
                 false);
}

std::vector<Row> touching_extrema(Lab& lab) {
  std::vector<Row> rows = rows_of(lab, "touching extrema",
                                  {{{0, 1, 2, 1, 0, 0}, 0},  // from below
                                   {{4, 3, 2, 3, 4, 4}, 0},  // from above
                                   {{2, 1, 0, 0, 1, 2}, 0},  // at the faces of the box
                                   {{2, 3, 4, 4, 3, 2}, 0}},
                                  true);
  // A pyramid whose tip has the isovalue, in a grid point that the middle ray meets
  const VolumePtr volume = make_volume(cube(9), [](glm::dvec3 p) {
    const glm::dvec3 d = glm::abs(p - glm::dvec3(4));
    return 8 - d.x - d.y - d.z;
  });
  Worst worst;
  std::vector<Image> pictures;
  for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 1, 1), glm::dvec3(1, 2, 0)})
    for (const double step : steps) {
      const CountedPicture picture =
          draw_counted(lab, make_scene(volume, peaks_at({8}, 0.5), Mode::peak_only, step),
                       looking_along(direction, glm::dvec3(4), 3), {9, 9});
      pictures.push_back(picture.image);
      for (const unsigned crossings : picture.crossings)
        worst.take(crossings, fmt::format("step {:g}", step));
    }
  rows.push_back(judge(counted("the tip of a pyramid", Truth::closed_form, true), worst, pictures));
  return rows;
}

std::vector<Row> regions_on_the_isovalue(Lab& lab) {
  std::vector<Row> rows = rows_of(
      lab, "regions with f = v",
      {{{0, 2, 2, 2, 1, 0}, 2}, {{0, 1, 2, 2, 3, 4}, 1}, {{2, 2, 1, 1, 2, 2}, 2}, {{0, 0, 2, 2, 2, 2}, 1}},
      false);
  const std::vector<Row> flat = rows_of(lab, "regions with f = v beside others of f > v",
                                        {{{4, 3, 2, 2, 3, 4}, 0}, {{2, 2, 2, 2, 2, 4}, 0}}, true);
  rows.insert(rows.end(), flat.begin(), flat.end());
  return rows;
}

std::vector<Row> integers_with_peaks_at_integers(Lab& lab) {
  // Samples at a quarter and at a half of a voxel fall on the isovalues again and again
  Worst worst;
  std::vector<Image> pictures;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    Random random(seed);
    std::vector<double> values;
    for (int i = 0; i < 48; ++i) values.push_back(std::floor(random.uniform(0, 5)));
    const VolumePtr volume = along_z_axis(values);
    double expected = 0;
    for (const double v : {1.0, 2.0, 3.0}) expected += crossings_of(values, v);
    for (const double step : {0.5, 0.25, 0.3, 1.0 / 16}) {
      Scene scene = make_scene(volume, peaks_at({1, 2, 3}, 0.05), Mode::peak_only, step);
      const CountedPicture picture = draw_counted(lab, scene, along_z(volume->grid, 1.5), small);
      pictures.push_back(picture.image);
      for (const unsigned crossings : picture.crossings)
        worst.take(std::abs(crossings - expected), fmt::format("seed {}, step {:g}", seed, step));
    }
  }
  std::vector<Row> rows{judge(counted("random integers along a ray, peaks at 1, 2 and 3"), worst, pictures)};

  Random random(7);
  const VolumePtr volume = make_volume(cube(9), [&](glm::dvec3) { return std::floor(random.uniform(0, 7)); });
  const std::vector<Row> exact = rows_against_exact(lab, "random integers in space, a peak at 3", volume, 3,
                                                    whole_volume_camera(volume->grid, 1));
  rows.insert(rows.end(), exact.begin(), exact.end());
  return rows;
}

std::vector<Row> roots_on_faces_edges_and_points(Lab& lab) {
  struct Place {
    const char* name;
    glm::dvec3 at, direction;
    double isovalue_share;
  };
  // The field is x + y + z in a box of 4: at the middle ray's root a cell's face, an edge, a point
  const Place places[] = {{"a face", {1.3, 2.6, 2}, {0, 0, 1}, 5.9 / 12},
                          {"an edge", {2, 2, 0.5}, {1, 1, 0}, 4.5 / 12},
                          {"a point", {2, 2, 2}, {1, 1, 1}, 6.0 / 12}};
  std::vector<Row> rows;
  for (const Place& place : places) {
    Worst count, error;
    std::vector<Image> pictures;
    const HazeAndPlane plane{.grid = cube(5), .weights = {1, 1, 1}, .isovalue_share = place.isovalue_share};
    const Camera camera = looking_along(place.direction, place.at, 4);
    constexpr glm::ivec2 size{9, 9};
    for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr})
      for (const double step : steps) {
        const CountedPicture picture = draw_counted(lab, scene_of(plane, mode, step), camera, size);
        const std::vector<glm::dvec4> truth = truth_of(plane, mode, camera, size);
        pictures.push_back(picture.image);
        const std::string where = fmt::format("{}, step {:g}", crest::name_of(mode), step);
        count.take(std::abs(double(picture.crossings[40]) - 1), where);
        error.take(largest_difference(picture.image, truth), where);
      }
    rows.push_back(judge({.name = fmt::format("a root on {}", place.name),
                          .quantity = "crossings missed or invented by the middle ray, at any step",
                          .bound = 0},
                         count, pictures));
    rows.push_back(judge({.name = fmt::format("a root on {}, and all around it", place.name),
                          .quantity = "largest error of a channel",
                          .bound = 1e-5},
                         error, pictures));
  }
  return rows;
}

std::vector<Row> three_roots_in_a_cell(Lab& lab) {
  // Along the diagonal of the cell the field is the cubic with Bernstein coefficients -1, 3, -3, 1
  const Grid cell = cube(2);
  const VolumePtr volume = make_volume(cell, [](glm::dvec3 p) {
    const double ones = p.x + p.y + p.z;
    return ones == 0 ? -1.0 : ones == 1 ? 3.0 : ones == 2 ? -3.0 : 1.0;
  });
  const Camera camera = looking_along({1, 1, 1}, glm::dvec3(0.5), 2);
  Worst worst;
  std::vector<Image> pictures;
  for (const double step : {0.25, 0.1, 1.0 / 64}) {
    const CountedPicture picture =
        draw_counted(lab, make_scene(volume, peaks_at({0}, 0.4), Mode::peak_only, step), camera, {9, 9});
    pictures.push_back(picture.image);
    worst.take(std::abs(double(picture.crossings[40]) - 3), fmt::format("step {:g}", step));
  }
  std::vector<Row> rows{judge(counted("three roots in a cell, along its diagonal"), worst, pictures)};
  const std::vector<Row> exact =
      rows_against_exact(lab, "three roots in a cell, all around", volume, 0, camera);
  rows.insert(rows.end(), exact.begin(), exact.end());
  return rows;
}

}  // namespace crest::stability
