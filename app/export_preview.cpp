#include "app/export_preview.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "app/picture_grid.h"
#include "render/measure/image_error.h"
#include "render/scene/scene.h"

namespace crest {
namespace {

void measure(ExportPreview& preview) {
  const std::vector<float> differences = pixel_differences(preview.here, preview.there);
  double squares = 0;
  std::size_t shown = 0, off = 0;
  for (std::size_t i = 0; i < differences.size(); ++i) {
    const glm::vec4 &a = preview.here.pixels[i], &b = preview.there.pixels[i];
    if (!(a.a > 0 || b.a > 0)) continue;
    ++shown;
    off += differences[i] > 1.0f / 255;
    preview.max = std::max(preview.max, double(differences[i]));
    const glm::dvec4 d = glm::dvec4(a) - glm::dvec4(b);
    squares += d.r * d.r + d.g * d.g + d.b * d.b + d.a * d.a;
  }
  if (shown == 0) return;
  preview.rmse = std::sqrt(squares / (4 * double(shown)));
  preview.share = double(off) / double(shown);
}

}  // namespace

Image draw_preset(Renderer& renderer, const Preset& preset, const std::shared_ptr<const Volume>& volume,
                  const Camera& camera, glm::ivec2 size) {
  gl::RenderTarget target(size, false);
  renderer.draw(make_scene(volume, preset), camera, target);
  return target.read_color();
}

ExportPreview compare_export(Image here, Image there) {
  ExportPreview preview{.here = std::move(here), .there = std::move(there)};
  measure(preview);
  return preview;
}

Image picture_of(const ExportPreview& preview, std::string_view target, glm::vec3 background) {
  const int brightening = preview.max > 0 ? std::clamp(int(std::floor(-std::log2(preview.max))), 0, 7) : 0;
  const float factor = float(1 << brightening);
  Image difference = preview.here;
  for (std::size_t i = 0; i < difference.pixels.size(); ++i) {
    const glm::vec4 d = glm::abs(preview.here.pixels[i] - preview.there.pixels[i]) * factor;
    // Opacity alone may differ, over a black background unseen
    const float grey = std::max({d.r, d.g, d.b, d.a});
    difference.pixels[i] =
        glm::vec4(std::max(d.r, 0.5f * grey), std::max(d.g, 0.5f * grey), std::max(d.b, 0.5f * grey), 1);
  }
  return picture_grid({{preview.here, "Crest"},
                       {preview.there, fmt::format("{}, RMSE {:.2g}", target, preview.rmse)},
                       {std::move(difference), fmt::format("difference, {} times", factor)}},
                      3, background);
}

}  // namespace crest
