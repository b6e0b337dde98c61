#include "app/report/knoll_study.h"

#include <fmt/core.h>

#include <chrono>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/report/page.h"
#include "app/report/report_pictures.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/preset_file.h"
#include "render/scene/camera.h"
#include "render/studies/knoll/variants.h"

namespace crest {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> write_pictures(const KnollReport& report, const fs::path& folder) {
  std::vector<std::string> names;
  const auto write = [&](const std::string& name, const Image& image) {
    write_image(folder / name, image, glm::vec3(0));
    names.push_back(name);
  };
  for (const KnollFigure& figure : knoll_figures())
    for (const KnollPanel& panel : figure.panels)
      if (const Shot* shot = find_shot(report.results, panel.group, panel.variant)) {
        write(knoll_picture_name(panel), shot->picture);
        write(knoll_error_picture_name(panel), shot->error_picture);
      }
  return names;
}

Json write_study(const KnollReport& report, const fs::path& folder) {
  make_folder(folder / "images");
  make_folder(folder / "presets");
  for (const KnollScene& scene : report.results.scenes)
    save_preset(folder / knoll_preset_name(scene),
                preset_of(scene, table1_variants(s_k_of_paper(report.size.x))[1]));
  const auto pictures = write_pictures(report, folder);
  const Json json = knoll_json(report);
  write_file_atomically(folder / "knoll.json", print_json(json));
  write_file_atomically(folder / "knoll.csv", knoll_csv(report));
  Json page = json;
  for (const std::string& name : pictures) page["pictures"][name] = data_address(folder / name);
  write_page(folder / "knoll.html", "Peak finding: the paper's results again", web_file("knoll.html"),
             web_file("knoll.js"), page);
  return json;
}

}  // namespace

void run_knoll_study(const StudyOptions& options) {
  using std::chrono::duration, std::chrono::steady_clock;
  KnollReport report;
  report.command = options.command;
  report.made_at = utc_now();
  KnollLab::Settings settings;
  if (options.size) settings.size = *options.size;
  settings.stop = options.stop;
  settings.cache_folder = cache_folder();
  settings.paint_error = error_picture;
  report.size = settings.size;
  KnollScenes scenes(options.data_folder, aspect_of(settings.size));
  const OffscreenContext context(options.device);
  report.renderer = context.renderer();
  const auto begin = steady_clock::now();
  const auto taken = [&] { return duration<double>(steady_clock::now() - begin).count(); };
  work_on_study(options, [&] {
    KnollLab lab(settings);
    report.results = measure_knoll(lab, scenes, options.budget_seconds, [&](const std::string& what) {
      fmt::print(stderr, "{:.0f} s: {}\n", taken(), what);
    });
  });
  report.seconds = taken();
  if (report.results.table1.empty())
    throw Error(
        fmt::format("{}: nothing was measured: the budget has no time for a scene", options.folder.string()));
  const Json json = write_study(report, options.folder);
  print_study(options, json, (options.folder / "knoll.html").string() + "\n");
}

}  // namespace crest
