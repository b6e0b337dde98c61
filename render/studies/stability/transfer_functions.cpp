#include <fmt/core.h>

#include <cmath>
#include <limits>

#include "presets/choices.h"
#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/studies/stability/cases.h"
#include "render/studies/stability/scenes.h"

// TFs that are narrow, crowded, flat, broken off or elsewhere.

namespace crest::stability {
namespace {

constexpr glm::ivec2 small{16, 16};
constexpr double peak_widths[] = {1e-1, 1e-2, 1e-3,  1e-4,  1e-5,  1e-6, 1e-7,
                                  1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 0};

std::string name_of_width(double width) {
  return width > 0 ? fmt::format("width {:.0e} of the range", width) : "a true spike";
}

/// A peak in haze, `width` of the range wide between its neighbours; 0 makes a true spike.
TransferFunction peak_of_width(ValueRange range, double width, double haze) {
  const glm::dvec3 blue(0.2, 0.4, 1), red(1, 0.3, 0.1);
  const double middle = 0.44;
  return remap_values(
      make_tf({point(0, haze, blue), point(middle - width / 2, haze, blue), point(middle, 0.8, red),
               point(middle + width / 2, haze, blue), point(1, haze, blue)},
              16 * range.width()),
      {0, 1}, range);
}

/// The field z/n along the view: every value of [0, 1] is met once.
VolumePtr ramp(int n, bool rising = true) {
  return make_volume(cube(n + 1), [=](glm::dvec3 p) { return (rising ? p.z : n - p.z) / n; });
}

/// All pixels of a picture that looks along a ramp are the same.
std::vector<glm::dvec4> everywhere(glm::dvec4 pixel) { return std::vector(small.x * small.y, pixel); }

glm::dvec4 over(glm::dvec4 front, glm::dvec3 color, double opacity) {
  return front + (1 - front.a) * opacity * glm::dvec4(color, 1);
}

glm::dvec4 haze_pixel(double opacity, double unit_distance, double length) {
  return glm::dvec4(-std::expm1(-extinction(opacity, unit_distance) * length));
}

}  // namespace

std::vector<Row> widths_of_peaks(Lab& lab) {
  const VolumePtr volume = gyroid_in_levels();
  const ValueRange range = volume->statistics.range;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  const auto draw = [&](double width) {
    return lab.draw(make_scene(volume, peak_of_width(range, width, 0), Mode::peak_only), camera);
  };
  const Image widest = draw(peak_widths[0]);
  std::vector<Row> rows;
  for (const double width : peak_widths) {
    const Image image = draw(width);
    Worst worst;
    worst.take(unequal_pixels(image, widest), "");
    rows.push_back(judge({.name = fmt::format("a peak of {}, PEAK_ONLY", name_of_width(width)),
                          .quantity = "pixels that are not bit-equal to those of width 1e-1",
                          .bound = 0,
                          .truth = Truth::invariance},
                         worst, {&image, 1}));
  }
  return rows;
}

std::vector<Row> widths_of_spikes_in_haze(Lab& lab) {
  const VolumePtr volume = gyroid_in_levels();
  const ValueRange range = volume->statistics.range;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  Worst worst;
  std::vector<Image> pictures;
  for (const double width : peak_widths) {
    if (width > 0.01) continue;  // no spike: it keeps its body
    pictures.push_back(
        lab.draw(make_scene(volume, peak_of_width(range, width, 0.1), Mode::peak_xor_dvr), camera));
    worst.take(largest_difference(pictures.back(), pictures.front()), name_of_width(width));
  }
  return {judge({.name = "spikes of width 1e-2 to 1e-12 in haze, and a true one, PEAK_XOR_DVR",
                 .quantity = "largest difference of a channel from width 1e-2",
                 .bound = 1e-6,
                 .truth = Truth::invariance},
                worst, pictures)};
}

std::vector<Row> colors_of_narrow_peaks(Lab& lab) {
  // However little of a peak the samples of DVR meet, what they add has its colour: premultiplied, (a, 0, 0,
  // a)
  const VolumePtr volume = gyroid_in_levels();
  const ValueRange range = volume->statistics.range;
  const Camera camera = whole_volume_camera(volume->grid, 1);
  Worst worst;
  std::vector<Image> pictures;
  for (const double width : peak_widths) {
    TransferFunction tf = peak_of_width(range, width, 0.01);
    for (auto& p : tf.points) p.color = {1, 0, 0};
    const Image image = lab.draw(make_scene(volume, tf, Mode::dvr_only), camera);
    std::vector<glm::dvec4> red;
    for (const glm::vec4& pixel : image.pixels)
      red.emplace_back(pixel.a, 0, 0, std::clamp(pixel.a, 0.f, 1.f));
    worst.take(largest_difference(image, red), name_of_width(width));
    pictures.push_back(image);
  }
  return {judge({.name = "a red peak of width 1e-1 to 1e-12 in red haze, DVR_ONLY",
                 .quantity = "how far a pixel is from (a, 0, 0, a) with a in [0, 1]",
                 .bound = 1e-6},
                worst, pictures)};
}

std::vector<Row> peaks_one_float_apart(Lab& lab) {
  std::vector<Row> rows;
  const glm::dvec3 red(1, 0, 0), green(0, 1, 0);
  const double low = double(0.3f), high = double(std::nextafter(0.3f, 1.0f)), middle = (low + high) / 2;
  const auto tf = make_tf({point(0, 0), point(low - 1e-3, 0), point(low, 0.6, red), point(middle, 0),
                           point(high, 0.7, green), point(high + 1e-3, 0), point(1, 0)});
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    Worst worst;
    std::vector<Image> pictures;
    for (const bool rising : {true, false})
      for (const double step : {16.0, 0.5, 1.0 / 16}) {
        const VolumePtr volume = ramp(16, rising);
        pictures.push_back(lab.draw(make_scene(volume, tf, mode, step), along_z(volume->grid, 8), small));
        const glm::dvec4 truth =
            rising ? over(over({}, red, 0.6), green, 0.7) : over(over({}, green, 0.7), red, 0.6);
        worst.take(largest_difference(pictures.back(), everywhere(truth)),
                   fmt::format("{}, step {:g}", rising ? "rising" : "falling", step));
      }
    rows.push_back(judge({.name = fmt::format("peaks one float apart, {}", crest::name_of(mode)),
                          .quantity = "largest error of a channel: both are met, the nearer one first",
                          .bound = 1e-6},
                         worst, pictures));
  }
  return rows;
}

std::vector<Row> few_and_many_peaks(Lab& lab) {
  std::vector<Row> rows;
  for (const int count : {2, 1000}) {
    const double opacity = count > 2 ? 2e-3 : 0.5;
    std::vector<double> values;
    for (int i = 0; i < count; ++i) values.push_back((i + 0.5) / count);
    Worst worst, wrong;
    std::vector<Image> pictures;
    for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr})
      for (const double step : {2.0, 0.5, 1.0 / 8}) {
        const VolumePtr volume = ramp(64);
        Scene scene = make_scene(volume, peaks_at(values, opacity, std::min(0.1 / count, 1e-3)), mode, step);
        const CountedPicture picture = draw_counted(lab, scene, along_z(volume->grid, 8), small);
        const std::string where = fmt::format("{}, step {:g}", crest::name_of(mode), step);
        pictures.push_back(picture.image);
        worst.take(largest_difference(picture.image,
                                      everywhere(glm::dvec4(-std::expm1(count * std::log1p(-opacity))))),
                   where);
        for (const unsigned crossings : picture.crossings)
          wrong.take(std::abs(double(crossings) - count), where);
      }
    rows.push_back(judge(
        {.name = fmt::format("{} peaks", count), .quantity = "largest error of a channel", .bound = 1e-5},
        worst, pictures));
    rows.push_back(judge({.name = fmt::format("{} peaks", count),
                          .quantity = fmt::format("crossings missed or invented, of {} a ray", count),
                          .bound = 0},
                         wrong, pictures));
  }
  return rows;
}

std::vector<Row> four_peaks_in_one_step(Lab& lab) {
  std::vector<Row> rows;
  const glm::dvec3 colors[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}};
  TransferFunction tf = peaks_at({0.55, 0.57, 0.59, 0.61}, 0.5, 1e-4);
  for (int i = 0; i < 4; ++i) tf.points[std::size_t(3 * i + 1)].color = colors[i];
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    Worst worst;
    std::vector<Image> pictures;
    for (const bool rising : {true, false})
      for (const double step : {8.0, 2.0}) {
        const VolumePtr volume = ramp(16, rising);
        pictures.push_back(lab.draw(make_scene(volume, tf, mode, step), along_z(volume->grid, 8), small));
        glm::dvec4 truth(0);
        for (int i = 0; i < 4; ++i) truth = over(truth, colors[rising ? i : 3 - i], 0.5);
        worst.take(largest_difference(pictures.back(), everywhere(truth)),
                   fmt::format("{}, step {:g}", rising ? "rising" : "falling", step));
      }
    rows.push_back(judge(
        {.name = fmt::format("four peaks inside one sample's change of value, {}", crest::name_of(mode)),
         .quantity = "largest error of a channel: all are met, in their order",
         .bound = 1e-6},
        worst, pictures));
  }
  return rows;
}

std::vector<Row> plateaus(Lab& lab) {
  // The plateau's edges lie where two segments of a ray meet: the midpoint rule is exact
  const double opacity = 0.7, unit_distance = 4;
  const auto wide = make_tf(
      {point(0, 0), point(0.25, 0), point(0.25, opacity), point(0.75, opacity), point(0.75, 0), point(1, 0)},
      unit_distance);
  const VolumePtr volume = ramp(16);
  Worst worst;
  std::vector<Image> pictures;
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both})
    for (const double step : {4.0, 0.5, 1.0 / 16}) {
      pictures.push_back(lab.draw(make_scene(volume, wide, mode, step), along_z(volume->grid, 8), small));
      worst.take(largest_difference(pictures.back(), everywhere(haze_pixel(opacity, unit_distance, 8))),
                 fmt::format("{}, step {:g}", crest::name_of(mode), step));
    }
  std::vector<Row> rows{
      judge({.name = "a plateau with steep sides", .quantity = "largest error of a channel", .bound = 1e-5},
            worst, pictures)};

  TransferFunction narrow = make_tf({point(0, 0), point(0.49, 0), point(0.495, opacity),
                                     point(0.505, opacity), point(0.51, 0), point(1, 0)});
  narrow.plateau_width = 0.02;
  Worst wrong;
  pictures.clear();
  for (const Mode mode : {Mode::peak_only, Mode::peak_xor_dvr}) {
    narrow.spike_width = 0.05;
    pictures.push_back(lab.draw(make_scene(volume, narrow, mode), along_z(volume->grid, 8), small));
    wrong.take(largest_difference(pictures.back(), everywhere(glm::dvec4(opacity))), crest::name_of(mode));
  }
  rows.push_back(judge({.name = "a plateau narrower than plateau_width, one surface",
                        .quantity = "largest error of a channel",
                        .bound = 1e-6},
                       wrong, pictures));
  return rows;
}

std::vector<Row> steps_of_the_tf(Lab& lab) {
  const double opacity = 0.7, unit_distance = 4;
  TransferFunction tf =
      make_tf({point(0, 0), point(0.5, 0), point(0.5, opacity), point(1, opacity)}, unit_distance);
  const VolumePtr volume = ramp(16);
  Worst worst;
  std::vector<Image> pictures;
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both})
    for (const double step : {4.0, 0.5, 1.0 / 16}) {
      pictures.push_back(lab.draw(make_scene(volume, tf, mode, step), along_z(volume->grid, 8), small));
      worst.take(largest_difference(pictures.back(), everywhere(haze_pixel(opacity, unit_distance, 8))),
                 fmt::format("{}, step {:g}", crest::name_of(mode), step));
    }
  std::vector<Row> rows{
      judge({.name = "a step", .quantity = "largest error of a channel", .bound = 1e-5}, worst, pictures)};

  tf.points[2].surface = {SurfaceMode::on, 0.4};
  Worst surface;
  pictures.clear();
  for (const double step : {4.0, 0.5, 1.0 / 16}) {
    pictures.push_back(
        lab.draw(make_scene(volume, tf, Mode::peak_only, step), along_z(volume->grid, 8), small));
    surface.take(largest_difference(pictures.back(), everywhere(glm::dvec4(0.4))),
                 fmt::format("step {:g}", step));
  }
  rows.push_back(judge(
      {.name = "a step made a surface, PEAK_ONLY", .quantity = "largest error of a channel", .bound = 1e-6},
      surface, pictures));
  return rows;
}

std::vector<Row> step_at_a_label(Lab& lab) {
  // Labels 1, 2, 3 in slabs; the TF's step lies at the label 2 itself, where its last point holds
  const double opacity = 0.5, unit_distance = 4;
  const TransferFunction tf =
      make_tf({point(1, 0), point(2, 0), point(2, opacity), point(3, opacity)}, unit_distance);
  const VolumePtr volume = make_volume(cube(9), [](glm::dvec3) { return 2; });
  Volume labels = *volume;
  labels.values.floats().front() =
      1;  // so that the range is that of the labels; the corner is out of the picture
  labels.values.floats().back() = 3;
  labels.statistics = compute_statistics(labels.grid, labels.values);
  const auto shared = std::make_shared<const Volume>(std::move(labels));
  Worst worst;
  std::vector<Image> pictures;
  for (const Mode mode : {Mode::dvr_only, Mode::peak_xor_dvr, Mode::both}) {
    pictures.push_back(lab.draw(make_scene(shared, tf, mode), along_z(shared->grid, 4), small));
    worst.take(largest_difference(pictures.back(), everywhere(haze_pixel(opacity, unit_distance, 8))),
               crest::name_of(mode));
  }
  return {judge({.name = "a step of the TF at the value of a region",
                 .quantity = "largest error of a channel",
                 .bound = 1e-5},
                worst, pictures)};
}

std::vector<Row> outside_the_data(Lab& lab) {
  std::vector<Row> rows;
  const VolumePtr volume = ramp(16);
  for (const bool above : {true, false})
    for (const bool clear : {false, true}) {
      const double at = above ? 10 : -10, near = clear ? 0 : 0.3;
      TransferFunction tf = make_tf(
          {point(at, above ? near : 0.2), point(at + 0.5, 0.8), point(at + 1, above ? 0.2 : near)}, 4);
      Worst worst;
      std::vector<Image> pictures;
      for (const Mode mode : tested_modes) {
        if (!clear && !shows_dvr(mode)) continue;  // there is no surface, and all else is empty
        pictures.push_back(lab.draw(make_scene(volume, tf, mode), along_z(volume->grid, 8), small));
        worst.take(largest_difference(pictures.back(), everywhere(haze_pixel(near, 4, 16))),
                   crest::name_of(mode));
      }
      rows.push_back(judge({.name = fmt::format("a TF wholly {} the data, {} at its end",
                                                above ? "above" : "below", clear ? "clear" : "hazy"),
                            .quantity = "largest error of a channel",
                            .bound = 1e-5,
                            .empty = clear},
                           worst, pictures));
    }
  return rows;
}

}  // namespace crest::stability
