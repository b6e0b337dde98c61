#include "render/measure/image_error.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <limits>

#include "presets/error.h"
#include "presets/number_text.h"
#include "render/measure/flip.h"

namespace crest {
namespace {

/// By channel; what is not a number is off without bound.
glm::dvec4 difference(const glm::dvec4& a, const glm::dvec4& b) {
  glm::dvec4 d = glm::abs(a - b);
  for (int i = 0; i < 4; ++i)
    if (std::isnan(d[i])) d[i] = std::numeric_limits<double>::infinity();
  return d;
}

double largest_channel(const glm::dvec4& v) { return std::max({v.x, v.y, v.z, v.w}); }

PixelDifference difference_at(const Reference& exact, const Image& image, std::size_t pixel) {
  const glm::dvec4 d = difference(exact.pixels[pixel], glm::dvec4(image.pixels[pixel]));
  return {largest_channel(d), d.x * d.x + d.y * d.y + d.z * d.z + d.w * d.w};
}

/// Those where either picture shows something: the ones that are compared, and the grazing ones.
struct ShownPixels {
  std::vector<std::size_t> compared, grazing;
};
ShownPixels shown_pixels(const Reference& exact, const Image& image) {
  ShownPixels shown;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    if (exact.pixels[i].a > 0 || !(image.pixels[i].a <= 0))
      (exact.grazing[i] ? shown.grazing : shown.compared).push_back(i);
  return shown;
}

/// The errors of the pixels with these indices.
PixelErrors errors_of(const Reference& exact, const Image& image, const std::vector<float>& flip,
                      const std::vector<std::size_t>& pixels) {
  PixelErrors errors;
  errors.pixels = pixels.size();
  if (pixels.empty()) return errors;
  const double count = double(pixels.size());
  std::vector<double> differences;
  double squares = 0;
  for (const std::size_t i : pixels) {
    const PixelDifference d = difference_at(exact, image, i);
    squares += d.squares;
    differences.push_back(d.most);
    errors.share += (differences.back() > one_step_of_8_bits) / count;
    errors.flip += flip[i] / count;
  }
  errors.rmse = std::sqrt(squares / (4 * count));
  errors.max = *std::ranges::max_element(differences);
  // The least difference that at least 99.9 % of the pixels do not exceed
  const auto rank = differences.begin() + std::ptrdiff_t(std::ceil(0.999 * count)) - 1;
  std::ranges::nth_element(differences, rank);
  errors.p999 = *rank;
  return errors;
}

ImageError::Crossings count_crossings(const Reference& exact, std::span<const std::uint32_t> found,
                                      const std::vector<std::size_t>& pixels) {
  ImageError::Crossings crossings;
  for (const std::size_t i : pixels) {
    const double wanted = exact.crossings[i], got = found[i];
    crossings.exact += wanted;
    crossings.missed += std::max(wanted - got, 0.0);
    crossings.invented += std::max(got - wanted, 0.0);
  }
  return crossings;
}

/// A count as a share of the exact picture's crossings. Where there is none, one is as bad as all.
double share_of_exact(const ImageError& error, double ImageError::Crossings::*count) {
  if (!error.crossings) return std::numeric_limits<double>::quiet_NaN();
  return *error.crossings.*count / std::max(error.crossings->exact, 1.0);
}

double of_pixels(const ImageError& error, double PixelErrors::*value) {
  return error.compared.pixels > 0 ? error.compared.*value : std::numeric_limits<double>::quiet_NaN();
}

constexpr ErrorMeasure measures[] = {
    {"share", "share of pixels off by more than 1/255",
     [](const ImageError& e) { return of_pixels(e, &PixelErrors::share); }},
    {"rmse", "root mean square error", [](const ImageError& e) { return of_pixels(e, &PixelErrors::rmse); }},
    {"max", "largest error", [](const ImageError& e) { return of_pixels(e, &PixelErrors::max); }},
    {"p999", "99.9th percentile of the error",
     [](const ImageError& e) { return of_pixels(e, &PixelErrors::p999); }},
    {"flip", "mean FLIP", [](const ImageError& e) { return of_pixels(e, &PixelErrors::flip); }},
    {"missed", "crossings missed, of all",
     [](const ImageError& e) { return share_of_exact(e, &ImageError::Crossings::missed); }},
    {"invented", "crossings invented, of all",
     [](const ImageError& e) { return share_of_exact(e, &ImageError::Crossings::invented); }},
};

}  // namespace

double ImageError::grazing_share() const {
  const double all = double(compared.pixels + grazing.pixels);
  return all > 0 ? double(grazing.pixels) / all : 0;
}

ImageError image_error(const Reference& exact, const Image& image, std::span<const std::uint32_t> crossings,
                       std::optional<glm::vec3> background) {
  const auto [compared, grazing] = shown_pixels(exact, image);
  std::vector<float> flip(image.pixels.size(), std::numeric_limits<float>::quiet_NaN());
  if (background)
    flip = flip_map(over_background(exact.image(), *background), over_background(image, *background));
  ImageError error;
  error.compared = errors_of(exact, image, flip, compared);
  error.grazing = errors_of(exact, image, flip, grazing);
  if (!crossings.empty()) error.crossings = count_crossings(exact, crossings, compared);
  return error;
}

std::vector<PixelDifference> compared_differences(const Reference& exact, const Image& image) {
  std::vector<PixelDifference> differences;
  for (const std::size_t i : shown_pixels(exact, image).compared)
    differences.push_back(difference_at(exact, image, i));
  return differences;
}

std::span<const ErrorMeasure> error_measures() { return measures; }

TargetError default_target() { return {&measures[0], 0.001}; }

TargetError parse_target(std::string_view text) {
  const auto equals = std::min(text.find('='), text.size());
  const auto measure = std::ranges::find(measures, text.substr(0, equals), &ErrorMeasure::id);
  const std::string_view number = text.substr(std::min(equals + 1, text.size()));
  const std::optional<double> most = read_number(number).number;
  if (measure == std::end(measures) || !most || *most < 0) {
    std::string ids;
    for (const ErrorMeasure& m : measures) ids += (ids.empty() ? "" : ", ") + std::string(m.id);
    throw Error(fmt::format("'{}' is not MEASURE=NUMBER, as in share=0.001; the measures are {}", text, ids));
  }
  return {&*measure, *most};
}

std::string to_string(const TargetError& target) {
  return fmt::format("{}={}", target.measure->id, target.most);
}

std::vector<float> pixel_differences(const Image& a, const Image& b) {
  std::vector<float> differences;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    differences.push_back(
        float(largest_channel(difference(glm::dvec4(a.pixels[i]), glm::dvec4(b.pixels[i])))));
  return differences;
}

}  // namespace crest
