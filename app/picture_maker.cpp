#include "app/picture_maker.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/picture_grid.h"
#include "app/preset_source.h"
#include "render/files/image.h"
#include "render/measure/tiles.h"
#include "render/renderer.h"
#include "ui/camera_control.h"

namespace crest {
namespace {

Image draw(Renderer& renderer, const Scene& scene, const Camera& camera, gl::RenderTarget& target,
           const std::stop_token& stop) {
  double ms_per_row = 0;
  draw_in_tiles(target.size(), ms_per_row, [&](Tile tile) {
    if (!stop.stop_requested()) renderer.draw(scene, camera, target, tile);
  });
  return target.read_color();
}

/// Side by side each view stands on its own background.
Image over(Image image, const Scene& scene, bool is_one_of_several) {
  if (!is_one_of_several) return image;
  return over_background(std::move(image), glm::vec3(scene.rendering.background));
}

std::optional<std::string> save(const PictureJob& job, const std::stop_token& stop, std::atomic<int>& done) {
  const OffscreenContext context;
  Renderer renderer({}, program_folder());
  gl::RenderTarget target(job.size, false);
  const glm::vec3 background(job.views.front().scene.rendering.background);
  for (int i = 0; i < job.pictures; ++i) {
    const Camera camera = turned(job.camera, i, job.pictures);
    std::vector<LabelledImage> images;
    for (const auto& [scene, label] : job.views)
      images.push_back(
          {over(draw(renderer, scene, camera, target, stop), scene, job.views.size() > 1), label});
    if (stop.stop_requested()) return std::nullopt;
    const int columns = images.size() > 1 ? 2 : 1;
    write_image(numbered(job.path, i, job.pictures),
                columns == 1 ? images.front().image : picture_grid(images, columns, background), background,
                preset_for_picture(job.preset, camera));
    ++done;
  }
  return job.pictures == 1
             ? fmt::format("Saved {}", job.path.string())
             : fmt::format("Saved {} to {}", numbered(job.path, 0, job.pictures).string(),
                           numbered(job.path, job.pictures - 1, job.pictures).filename().string());
}

}  // namespace

std::filesystem::path numbered(const std::filesystem::path& path, int index, int count) {
  return count == 1 ? path : with_number(path, index + 1, count);
}

std::filesystem::path with_number(const std::filesystem::path& path, int number, int largest) {
  const int digits = std::max(3, int(fmt::format("{}", largest).size()));
  std::filesystem::path name = path;
  name.replace_filename(
      fmt::format("{}-{:0{}}{}", path.stem().string(), number, digits, path.extension().string()));
  return name;
}

Camera turned(const Camera& camera, int index, int count) {
  return index == 0 ? camera : orbit(camera, 2 * std::numbers::pi * index / count, 0);
}

PictureMaker::PictureMaker()
    : task_([done = done_](const PictureJob& job, const std::stop_token& stop) {
        return save(job, stop, *done);
      }) {}

void PictureMaker::start(PictureJob job) {
  name_ = job.path.filename().string();
  count_ = job.pictures;
  *done_ = 0;
  task_.start(std::move(job));
}

std::string PictureMaker::progress() const {
  if (!is_busy()) return "";
  return count_ == 1 ? fmt::format("Saving {}", name_)
                     : fmt::format("Saving {}: {} of {}", name_, std::min(*done_ + 1, count_), count_);
}

}  // namespace crest
