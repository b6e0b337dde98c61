#include <fmt/core.h>

#include <bit>
#include <cmath>
#include <limits>

#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/views.h"
#include "render/volume/convert.h"
#include "render/volume/random.h"

// Values of a field that are tiny, huge, far from zero, negative, all the same, or not there.

namespace crest::stability {
namespace {

constexpr glm::ivec2 small{16, 16};

std::vector<glm::dvec4> gray(double opacity) {
  return std::vector(std::size_t(small.x * small.y), glm::dvec4(opacity));
}

double haze(double opacity, double unit_distance, double length) {
  return -std::expm1(-extinction(opacity, unit_distance) * length);
}

Change scaled(const char* name, double scale) {
  return {name, [=](const View& view) { return with_values(view, scale, 0); }};
}

/// The gyroid in 16 steps over [0, 1]: with 1e6 added they are neighbours among the float32 numbers.
VolumePtr gyroid_in_sixteen_steps() {
  Volume volume = *gyroid_in_levels();
  const ValueRange range = volume.statistics.range;
  for (float& value : volume.values.floats())
    value = float(std::round(16 * (value - range.min) / range.width()) / 16);
  volume.statistics = compute_statistics(volume.grid, volume.values);
  return std::make_shared<const Volume>(std::move(volume));
}

/// Haze with a surface against the exact picture, in each mode.
std::vector<Row> rows_against_exact(Lab& lab, const std::string& name, const VolumePtr& volume,
                                    double isovalue) {
  std::vector<Row> rows;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  for (const Mode mode : tested_modes) {
    const TransferFunction tf = haze_with_surface(volume->statistics.range, isovalue, 0.2, 0.5,
                                                  8 * volume->grid.smallest_spacing(), mode);
    const Scene scene = make_scene(volume, tf, mode, fine_step);
    const CountedPicture picture = draw_counted(lab, scene, camera, lab.size);
    const Deviation off = deviation_from_exact(picture, scene, camera, nearly_grazing(lab, {scene, camera}));
    Worst error;
    error.take(off.largest, "");
    rows.push_back(judge({.name = fmt::format("{}, {}", name, crest::name_of(mode)),
                          .quantity = "largest error of a channel, haze with a surface in it",
                          .bound = 1e-4,
                          .truth = Truth::reference},
                         error, {&picture.image, 1}, off.left_out));
  }
  return rows;
}

}  // namespace

std::vector<Row> tiny_and_huge_values(Lab& lab) {
  return rows_of_changes(
      lab, "values around 1e-30 and 1e30", plain_view,
      {scaled("7.9e-31 (2^-100)", 0x1p-100), scaled("1.3e30 (2^100)", 0x1p100),
       scaled("denormal (2^-140)", 0x1p-140), scaled("near the largest (2^126)", 0x1p126)});
}

std::vector<Row> far_from_zero(Lab& lab) {
  const auto plain = [](Mode mode) {
    const VolumePtr volume = gyroid_in_sixteen_steps();
    const double voxel = volume->grid.smallest_spacing();
    return View{make_scene(volume, haze_and_peaks(volume->statistics.range, 8 * voxel), mode, fine_step),
                whole_volume_camera(volume->grid, 1)};
  };
  std::vector<Change> changes;
  for (const double offset : {1e6, -1e6 - 1})
    changes.push_back(
        {fmt::format("{:g}", offset), [=](const View& view) { return with_values(view, 1, offset); }});
  std::vector<Row> rows = rows_of_changes(lab, "an offset of 1e6 with variation of 1", plain, changes);
  const View moved = with_values(plain(Mode::peak_only), 1, 1e6);
  const std::vector<Row> exact =
      rows_against_exact(lab, "an offset of 1e6 with variation of 1", moved.scene.volume, 1e6 + 0.7);
  rows.insert(rows.end(), exact.begin(), exact.end());
  return rows;
}

std::vector<Row> signed_values(Lab& lab) {
  // The same 16 bits, read as signed and as unsigned, on either side of the sign bit
  const VolumePtr gyroid = gyroid_in_levels();
  const auto read = [&](ScalarType type, int offset) {
    std::vector<std::uint16_t> stored;
    for (const float value : gyroid->values.to_floats())
      stored.push_back(std::uint16_t(std::lround(64 * value) * 100 - 2000 + offset));
    Volume volume = *gyroid;
    convert_to_float(std::as_bytes(std::span(stored)), type, 1, volume.values.floats());
    volume.file_type = type;
    volume.statistics = compute_statistics(volume.grid, volume.values);
    return std::make_shared<const Volume>(std::move(volume));
  };
  const VolumePtr as_signed = read(ScalarType::int16, 0), as_unsigned = read(ScalarType::uint16, 32768);
  const double voxel = gyroid->grid.smallest_spacing();
  const auto plain = [&](Mode mode) {
    return View{
        make_scene(as_signed, haze_and_peaks(as_signed->statistics.range, 8 * voxel), mode, fine_step),
        whole_volume_camera(gyroid->grid, 1)};
  };
  const Change shifted{"as unsigned, 32768 more", [&](const View& view) {
                         View other = view;
                         other.scene.volume = as_unsigned;
                         for (auto& p : other.scene.tf.points) p.value += 32768;
                         return other;
                       }};
  return rows_of_changes(lab, "16-bit signed with negative values", plain, {shifted});
}

std::vector<Row> constant_volumes(Lab& lab) {
  Worst error;
  std::vector<Image> hazy, clear;
  Worst invented;
  for (const double value : {0.0, 5.0, -3.0, 1e30, 1e-30}) {
    const VolumePtr volume = make_volume(cube(9), [=](glm::dvec3) { return value; });
    const double width = value == 0 ? 1 : std::abs(value);
    const TransferFunction tf =
        make_tf({point(value - width, 0), point(value - width / 2, 0.3), point(value + width, 0.3)}, 4);
    for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
      hazy.push_back(lab.draw(make_scene(volume, tf, mode), along_z(volume->grid, 6), small));
      error.take(largest_difference(hazy.back(), gray(haze(0.3, 4, 8))), fmt::format("{}", value));
    }
    TransferFunction peak = make_tf({point(value - width, 0), point(value, 0.5), point(value + width, 0)});
    clear.push_back(lab.draw(make_scene(volume, peak, Mode::peak_only), along_z(volume->grid, 6), small));
    invented.take(largest_difference(clear.back(), gray(0)), fmt::format("{}", value));
  }
  return {
      judge({.name = "a constant volume, in haze", .quantity = "largest error of a channel", .bound = 1e-5},
            error, hazy),
      judge({.name = "a constant volume, a peak at its value, PEAK_ONLY",
             .quantity = "largest channel: all of it is inside, there is no surface",
             .bound = 0,
             .empty = true},
            invented, clear)};
}

std::vector<Row> voxels_without_a_value(Lab& lab) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const auto hole = [=](glm::dvec3 p) { return p.x < 3 ? nan : p.x < 6 ? inf : -inf; };
  // The two layers of cells beside z = 4 are empty; on either side of them the field is 0 and 1
  const VolumePtr halves = make_volume(cube(9), [=](glm::dvec3 p) {
    return p.z == 4 ? hole(p) : p.z < 4 ? 0.0 : 1.0;
  });
  Worst error, invented;
  std::vector<Image> hazy, clear;
  for (const double step : {2.0, 0.5, 1.0 / 16}) {
    for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
      const Scene scene = make_scene(halves, make_tf({point(0, 0.3), point(1, 0.3)}, 4), mode, step);
      hazy.push_back(lab.draw(scene, along_z(halves->grid, 6), small));
      error.take(largest_difference(hazy.back(), gray(haze(0.3, 4, 6))), fmt::format("step {:g}", step));
    }
    clear.push_back(lab.draw(make_scene(halves, peaks_at({0.5}, 0.9), Mode::peak_only, step),
                             along_z(halves->grid, 6), small));
    invented.take(largest_difference(clear.back(), gray(0)), fmt::format("step {:g}", step));
  }
  std::vector<Row> rows{judge({.name = "NaN and Inf corners, haze around them",
                               .quantity = "largest error of a channel",
                               .bound = 1e-5},
                              error, hazy),
                        judge({.name = "NaN and Inf corners between 0 and 1, a peak at 0.5, PEAK_ONLY",
                               .quantity = "largest channel: no surface is invented",
                               .bound = 0,
                               .empty = true},
                              invented, clear)};

  Volume holed = *gyroid_in_levels();
  Random random(3);
  for (float& value : holed.values.floats()) {
    const double chance = random.uniform(0, 1);
    if (chance < 0.02) value = float(chance < 0.01 ? nan : chance < 0.015 ? inf : -inf);
  }
  holed.statistics = compute_statistics(holed.grid, holed.values);
  const std::vector<Row> exact = rows_against_exact(lab, "NaN and Inf at random points",
                                                    std::make_shared<const Volume>(std::move(holed)), 0.3);
  rows.insert(rows.end(), exact.begin(), exact.end());
  return rows;
}

}  // namespace crest::stability
