#include "app/report/report_pictures.h"

#include <fmt/core.h>

#include <algorithm>
#include <glm/common.hpp>

#include "presets/json.h"
#include "render/measure/model_difference.h"
#include "render/scene/error_colors.h"

namespace crest {
namespace {

constexpr std::uint32_t not_compared = 0x5b6470, grazing = 0x2aa198;

glm::vec4 color_of(std::uint32_t rgb) {
  return {float(rgb >> 16) / 255, float(rgb >> 8 & 255) / 255, float(rgb & 255) / 255, 1};
}

std::string in_file_name(std::string text) {
  std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == ','; });
  std::ranges::replace_if(
      text, [](char c) { return c == '+' || c == ' '; }, '-');
  return text;
}

std::string stem(const Measurement& point) {
  return point.step > 0 ? fmt::format("{}-step-{}", point.method, point.step) : point.method;
}

std::string file_name(const std::string& stem) { return fmt::format("images/{}.png", in_file_name(stem)); }

}  // namespace

ErrorColors error_colors() {
  const auto text = [](std::uint32_t rgb) { return fmt::format("#{:06x}", rgb); };
  ErrorColors colors{{}, text(not_compared), text(grazing)};
  for (const glm::vec3 color : error_scale()) {
    const glm::uvec3 rgb(glm::round(255.0F * color));
    colors.scale.push_back(text(rgb.r << 16 | rgb.g << 8 | rgb.b));
  }
  return colors;
}

Json error_scale_json() {
  const ErrorColors colors = error_colors();
  return {{"least", least_shown_error},
          {"most", most_shown_error},
          {"colors", colors.scale},
          {"not_compared", colors.not_compared},
          {"grazing", colors.grazing}};
}

Image error_picture(const Reference& exact, const Image& image) {
  const Image wanted = exact.image();
  const auto differences = pixel_differences(wanted, image);
  Image picture{image.size, {}};
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const bool is_compared = wanted.pixels[i].a > 0 || !(image.pixels[i].a <= 0);
    picture.pixels.push_back(!is_compared       ? color_of(not_compared)
                             : exact.grazing[i] ? color_of(grazing)
                                                : glm::vec4(error_color(double(differences[i])), 1));
  }
  return picture;
}

std::string picture_name(const Measurement& point) { return file_name(stem(point)); }

std::string error_picture_name(const Measurement& point, const ExactAnswer& answer) {
  return file_name(fmt::format("{}-error-{}", stem(point), name_of(answer)));
}

std::string exact_picture_name(const ExactAnswer& answer) {
  return file_name(fmt::format("exact-{}", name_of(answer)));
}

std::string difference_picture_name(const ExactAnswer& answer) {
  return file_name(fmt::format("model-difference-{}", name_of(answer)));
}

std::vector<std::string> write_pictures(const Report& report, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  const auto write = [&](const std::string& name, const Image& image) {
    write_image(folder / name, image, report.background());
    names.push_back(name);
  };
  for (const auto& [answer, exact] : report.references) {
    write(exact_picture_name(answer), exact.image());
    if (model_difference(report.references, answer, report.scene.rendering))
      write(difference_picture_name(answer),
            error_picture(report.references.at(own_integral(report.scene.rendering)), exact.image()));
  }
  for (const auto& [index, image] : report.pictures) {
    const Measurement& point = report.points[index];
    write(picture_name(point), image);
    for (const auto& [answer, error] : point.errors)
      write(error_picture_name(point, answer), error_picture(report.references.at(answer), image));
  }
  return names;
}

}  // namespace crest
