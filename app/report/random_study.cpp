#include "app/report/random_study.h"

#include <fmt/core.h>

#include <chrono>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/report/page.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"

namespace crest {
namespace {

void study_scenes(RandomReport& report, const StudyOptions& options) {
  using std::chrono::duration, std::chrono::steady_clock;
  const auto begin = steady_clock::now();
  const auto taken = [&] { return duration<double>(steady_clock::now() - begin).count(); };
  Renderer renderer;
  ProgressBar bar;
  for (RandomScene& scene : random_scenes(options.seed)) {
    if (options.budget_seconds && !report.scenes.empty() && taken() > *options.budget_seconds) break;
    const int index = int(report.scenes.size());
    RandomStudySettings settings{.size = report.size, .cache = cache_folder(), .stop = options.stop};
    settings.progress = [&](std::string_view method, double done) {
      bar.show((index + done) / random_scene_count,
               fmt::format("scene {}, {}, {}: {}", index, scene.field, scene.features, method));
    };
    report.studies.push_back(study_random_scene(renderer, scene, index, settings));
    report.scenes.push_back(std::move(scene));
  }
  report.seconds = taken();
}

Json write_study(const RandomReport& report, const std::filesystem::path& folder) {
  make_folder(folder / "images");
  const Json json = random_json(report);
  Json page = json;
  for (int i = 0; i < int(report.studies.size()); ++i) {
    const std::string name = random_picture_name(i);
    write_image(folder / name, report.studies[std::size_t(i)].exact, glm::vec3(0));
    page["pictures"][name] = data_address(folder / name);
  }
  write_file_atomically(folder / "random.json", print_json(json));
  write_file_atomically(folder / "random.csv", random_csv(report));
  write_page(folder / "random.html", "Every method on random scenes", web_file("random.html"),
             web_file("random.js"), page);
  return json;
}

}  // namespace

std::vector<SceneGroup> groups_of(const RandomReport& report) {
  std::vector<SceneGroup> groups{
      {"all", "All scenes", {}}, {"others", "Scenes without labels", {}}, {"labels", "Scenes of labels", {}}};
  std::vector<RandomMeasurement> measurements;
  for (const RandomSceneStudy& study : report.studies)
    measurements.insert(measurements.end(), study.measurements.begin(), study.measurements.end());
  for (SceneGroup& group : groups) {
    const auto is_in = [&](int scene) {
      return group.id == "all" || report.scenes[std::size_t(scene)].labels == (group.id == "labels");
    };
    group.summaries = summarize(measurements, is_in);
    for (int i = 0; i < int(report.scenes.size()); ++i) group.scenes += is_in(i);
  }
  return groups;
}

std::string random_picture_name(int scene) { return fmt::format("images/scene-{}.png", scene); }

void run_random_study(const StudyOptions& options) {
  RandomReport report;
  report.command = options.command;
  report.made_at = utc_now();
  report.seed = options.seed;
  report.size = options.size.value_or(RandomStudySettings{}.size);
  const OffscreenContext context(options.device);
  report.renderer = context.renderer();
  work_on_study(options, [&] { study_scenes(report, options); });
  const Json json = write_study(report, options.folder);
  print_study(options, json, random_table(report) + (options.folder / "random.html").string() + "\n");
}

}  // namespace crest
