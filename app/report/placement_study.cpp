#include "app/report/placement_study.h"

#include <fmt/core.h>

#include "app/load_with_progress.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/report/page.h"
#include "app/report/report_pictures.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/names.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

constexpr glm::ivec2 paper_size{500, 500}, scene_size{256, 256};
constexpr int timed_rounds = 15;

/// Of VOLUME, if there is one.
PlacementScene border_scene_of(const SceneOptions& options, double aspect) {
  if (options.volume.empty()) return builtin_border_scene(aspect);
  const auto volume = std::make_shared<const Volume>(load_with_progress(options.volume));
  const Preset preset = options.read_preset(*volume, aspect);
  return border_scene(make_scene(volume, preset), camera_of(preset, volume->grid, aspect));
}

void study_scenes(PlacementReport& report, Raycaster& raycaster, const StudyOptions& options) {
  const glm::ivec2 size = options.size.value_or(scene_size);
  const double aspect = aspect_of(size);
  const PlacementScene border = border_scene_of(options.scene, aspect), clipped = clipped_plume(aspect);
  constexpr double parts = 5;  // four scenes, and the frame times
  ProgressBar bar;
  const auto add = [&](const PlacementScene& scene, glm::ivec2 pixels) {
    bar.show(double(report.volumes.size()) / parts, scene.title);
    report.volumes.push_back(study_volume(raycaster, scene, pixels, options.stop));
  };
  add(extruded_square(), options.size.value_or(paper_size));
  report.distance_from_plane = distance_from_plane(report.volumes.front());
  for (const PlacementScene& scene : {border, whole_plume(aspect), clipped}) add(scene, size);
  report.clip_against_crop = clip_against_crop(raycaster, clipped, size);
  bar.show(4 / parts, "frame times");
  report.timed_scene = border.id;
  report.timed_size = size;
  report.times = time_placements(raycaster, border, report.timed_step, size, timed_rounds, options.stop);
}

std::vector<std::string> write_pictures(const PlacementReport& report, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const VolumeStudy& study : report.volumes) {
    const auto write = [&](const std::string& name, const Image& image) {
      write_image(folder / name, image, study.scene.scene.rendering.background);
      names.push_back(name);
    };
    const std::string& id = study.scene.id;
    write(placement_exact_picture_name(id), study.exact.image());
    for (const VolumePlacement& placement : study.placements) {
      write(placement_picture_name(id, placement.placement), placement.picture);
      write(placement_error_picture_name(id, placement.placement),
            error_picture(study.exact, placement.picture));
    }
  }
  return names;
}

Json write_study(const PlacementReport& report, const std::filesystem::path& folder) {
  make_folder(folder / "images");
  const auto pictures = write_pictures(report, folder);
  const Json json = placement_json(report);
  write_file_atomically(folder / "placement.json", print_json(json));
  write_file_atomically(folder / "placement.csv", placement_csv(report));
  Json page = json;
  for (const std::string& name : pictures) page["pictures"][name] = data_address(folder / name);
  write_page(folder / "placement.html", "Where to place the samples", web_file("placement.html"),
             web_file("placement.js"), page);
  return json;
}

}  // namespace

std::string placement_exact_picture_name(const std::string& scene) {
  return fmt::format("images/{}-exact.png", scene);
}

std::string placement_picture_name(const std::string& scene, Placement placement) {
  return fmt::format("images/{}-{}.png", scene, name_of(placement));
}

std::string placement_error_picture_name(const std::string& scene, Placement placement) {
  return fmt::format("images/{}-{}-error.png", scene, name_of(placement));
}

void run_placement_study(const StudyOptions& options) {
  PlacementReport report;
  report.command = options.command;
  report.made_at = utc_now();
  report.plane = study_plane();
  const OffscreenContext context(options.device);
  report.renderer = context.renderer();
  Raycaster raycaster;
  work_on_study(options, [&] { study_scenes(report, raycaster, options); });
  const Json json = write_study(report, options.folder);
  print_study(options, json, (options.folder / "placement.html").string() + "\n");
}

}  // namespace crest
