#include "app/picture.h"

#include <fmt/core.h>

#include <algorithm>

#include "presets/json.h"
#include "presets/names.h"
#include "presets/printable.h"
#include "render/measure/tiles.h"
#include "render/measure/timing.h"
#include "render/notes.h"
#include "render/scene/float_precision.h"

namespace crest {

std::vector<MeasuredPicture> measure_pictures(Renderer& renderer, const std::vector<Scene>& scenes,
                                              const Camera& camera, glm::ivec2 size, int frames,
                                              bool count_costs) {
  std::vector<MeasuredPicture> pictures(scenes.size());
  gl::RenderTarget target(size, false);
  std::vector<double> ms_per_row(scenes.size());
  const auto draw = [&](std::size_t i) {
    return draw_in_tiles(size, ms_per_row[i],
                         [&](Tile tile) { renderer.draw(scenes[i], camera, target, tile); });
  };
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    pictures[i].first_frame_ms = draw(i);
    pictures[i].image = target.read_color();
    pictures[i].need = renderer.need(scenes[i], camera, size);
    pictures[i].warnings = scene_warnings(scenes[i], camera, size);
    pictures[i].notes = picture_notes(scenes[i], camera, pictures[i].image);
  }
  for (int frame = 1; frame < frames; ++frame)
    for (std::size_t i = 0; i < scenes.size(); ++i) pictures[i].frame_ms.push_back(draw(i));
  for (auto& picture : pictures)
    if (picture.frame_ms.empty()) picture.frame_ms = {picture.first_frame_ms};
  if (count_costs) {
    gl::RenderTarget counted(size, true);
    for (std::size_t i = 0; i < scenes.size(); ++i) {
      const auto pixels = renderer.draw_counts(scenes[i], camera, counted);
      pictures[i].counts = sum_of(pixels);
      for (const PixelCounts& pixel : pixels) pictures[i].error_bounds.push_back(pixel.error_bound);
    }
  }
  return pictures;
}

namespace {

void print_each_once(const char* kind, const std::vector<std::string>& sentences) {
  for (auto sentence = sentences.begin(); sentence != sentences.end(); ++sentence)
    if (std::find(sentences.begin(), sentence, *sentence) == sentence)
      fmt::print(stderr, "crest: {}: {}\n", kind, printable(*sentence));
}

}  // namespace

void print_warnings(const std::vector<std::string>& warnings) { print_each_once("warning", warnings); }
void print_notes(const std::vector<std::string>& notes) { print_each_once("note", notes); }

nlohmann::ordered_json peaks_json(const std::vector<Peak>& surfaces) {
  auto json = nlohmann::ordered_json::array();
  for (const Peak& peak : surfaces)
    json.push_back({{"value", peak.value}, {"opacity", peak.opacity}, {"width", peak.width}});
  return json;
}

namespace {

/// What a picture needs of the device, and what was left out of it.
void add_need(nlohmann::ordered_json& json, const PictureNeed& need) {
  json["features"] = need.features.in;
  for (const auto& [name, why] : need.features.left_out) json["left_out"][name] = why;
  json["notes"] = need.features.notes;
  json["tables"] = nlohmann::ordered_json::object();
  for (const GpuData& data : need.gpu_data)
    json["tables"][data.name] = {{"size", data.size}, {"bytes", data.bytes}};
  if (need.tf_error) json["tables"]["transfer_function"]["error"] = *need.tf_error;
}

}  // namespace

nlohmann::ordered_json statistics_json(const MeasuredPicture& picture, Renderer& renderer,
                                       const Scene& scene) {
  const RenderCounts& counts = picture.counts;
  const double hit_pixels = std::max(counts.hit_pixels, 1.0);
  const auto& classification = renderer.classification(scene);
  nlohmann::ordered_json json;
  json["mode"] = name_of(scene.rendering.mode);
  json["engine"] = name_of(scene.rendering.engine);
  json["frame_ms"] = median(picture.frame_ms);
  json["frame_ms_all"] = picture.frame_ms;
  json["first_frame_ms"] = picture.first_frame_ms;
  json["samples_per_ray"] = counts.samples / counts.pixels;
  json["dvr_samples_per_ray"] = counts.dvr_samples / counts.pixels;
  json["crossings_per_ray"] = counts.crossings / counts.pixels;
  json["crossings_left_out_per_ray"] = counts.crossings_left_out / counts.pixels;
  json["samples_per_hit_ray"] = counts.samples / hit_pixels;
  json["dvr_samples_per_hit_ray"] = counts.dvr_samples / hit_pixels;
  json["hit_rays"] = counts.hit_pixels;
  if (counts.bounded_pixels > 0)
    json["error_at_most"] = {{"greatest", counts.greatest_error_bound},
                             {"share_within_1_255", counts.pixels_within_bound / counts.bounded_pixels}};
  json["peaks"] = peaks_json(classification.surfaces);
  add_need(json, picture.need);
  for (const std::string& note : picture.notes) json["notes"].push_back(note);
  json["warnings"] = picture.warnings;
  return json;
}

}  // namespace crest
