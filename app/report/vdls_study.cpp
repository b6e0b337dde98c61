#include "app/report/vdls_study.h"

#include <fmt/core.h>

#include <algorithm>

#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/report/page.h"
#include "app/report/report_pictures.h"
#include "presets/atomic_file.h"
#include "presets/choices.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/names.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"

namespace crest {
namespace {

constexpr glm::ivec2 default_size{128, 128};
constexpr int most_views = 100;

/// What a part of the study draws with, and for how long.
struct Lab {
  Renderer renderer;
  glm::ivec2 size;
  std::optional<double> budget_seconds;
  std::stop_token stop;

  /// For a share of the budget.
  std::vector<std::vector<VdlsTiming>> time(const std::vector<VdlsSubject>& subjects, double share) {
    return time_subjects(renderer, subjects, {budget_seconds.value_or(1e9) * share, most_views, stop});
  }
  std::vector<VdlsTiming> time(const Scene& scene, const std::vector<VdlsSetup>& setups, double share) {
    return std::move(time({{scene, size, setups}}, share).front());
  }
  Image picture(Scene scene, const Camera& camera, Engine engine) {
    if (stop.stop_requested()) throw Cancelled();
    scene.rendering.engine = engine;
    gl::RenderTarget target(size, false);
    renderer.draw(scene, camera, target);
    return target.read_color();
  }
};

/// The pictures of both engines are kept.
VdlsReport::Difference picture_pair(VdlsReport& report, Lab& lab, const std::string& id, const Scene& scene) {
  const Camera camera = whole_volume_camera(scene.volume->grid, aspect_of(lab.size));
  const Image raycaster = lab.picture(scene, camera, Engine::raycaster);
  report.pictures.push_back({fmt::format("images/{}-raycaster.png", id), raycaster});
  const auto vdls = [&](bool gradient_volume) {
    Scene with = scene;
    with.rendering.vdls.gradient_volume = gradient_volume;
    return lab.picture(with, camera, Engine::vdls);
  };
  const auto difference = [&](const Image& image) {
    return double(std::ranges::max(pixel_differences(image, raycaster)));
  };
  const Image precomputed = vdls(true);
  report.pictures.push_back({fmt::format("images/{}-vdls.png", id), precomputed});
  return {difference(vdls(false)), difference(precomputed)};
}

double bytes_of(Renderer& renderer, Scene scene, glm::ivec2 size, Engine engine) {
  scene.rendering.engine = engine;
  double bytes = 0;
  for (const GpuData& data :
       renderer.need(scene, whole_volume_camera(scene.volume->grid, aspect_of(size)), size).gpu_data)
    bytes += double(data.bytes);
  return bytes;
}

void study_table(VdlsReport& report, Lab& lab, const std::vector<VdlsScene>& scenes) {
  for (const VdlsScene& scene : scenes) {
    fmt::print(stderr, "table 2: {}\n", scene.title);
    VdlsReport::Row row{scene.id, scene.title, scene.scene.volume->grid.dims, 0, 0, {}, {}};
    row.timings = lab.time(scene.scene, table_setups(), 0.06);
    row.vdls_bytes = bytes_of(lab.renderer, scene.scene, lab.size, Engine::vdls);
    row.raycaster_bytes = bytes_of(lab.renderer, scene.scene, lab.size, Engine::raycaster);
    row.difference = picture_pair(report, lab, scene.id, scene.scene);
    report.table.push_back(std::move(row));
  }
}

/// Points of a series that are to be drawn.
struct Points {
  std::vector<VdlsSeries::Point> points;
  std::vector<VdlsSubject> subjects;

  void add(double x, std::string label, VdlsSubject subject) {
    points.push_back({x, std::move(label), {}});
    subjects.push_back(std::move(subject));
  }
  std::vector<VdlsSeries::Point> timed(Lab& lab, double share) {
    auto timings = lab.time(subjects, share);
    for (std::size_t i = 0; i < points.size(); ++i) points[i].timings = std::move(timings[i]);
    return std::move(points);
  }
};

/// Figure 5: a range of values is opaque, one after the other.
VdlsSeries study_ranges(Lab& lab, const VdlsScene& hydrogen) {
  VdlsOptions without;
  without.homo_regions = false;
  auto setups = engine_setups();
  setups.front().name = "VDLS with homo-regions";
  setups.insert(setups.begin(), vdls_setup("VDLS without homo-regions", without));
  VdlsSeries series{"intervals",
                    "Figure 5: an interval of values is opaque, of " + hydrogen.title,
                    "interval of the volume's range",
                    {},
                    {}};
  Scene scene = hydrogen.scene;
  constexpr int intervals = 8;
  Points points;
  for (int i = 0; i < intervals; ++i) {
    const double from = double(i) / intervals, to = double(i + 1) / intervals;
    scene.tf = opaque_range(scene.volume->statistics.range, from, to);
    points.add(i + 1, fmt::format("{:.3f} to {:.3f}", from, to), {scene, lab.size, setups});
  }
  series.points = points.timed(lab, 0.12);
  return series;
}

/// Figure 6: quadtrees over a picture, and what they bring.
void study_quadtrees(VdlsReport& report, Lab& lab, const VdlsScene& scene) {
  struct Variant {
    const char* title;
    int leaves, threshold;
  };
  std::vector<VdlsSetup> setups;
  const Camera camera = whole_volume_camera(scene.scene.volume->grid, aspect_of(lab.size));
  for (const Variant& v : {Variant{"no quadtree", 0, 0},
                           {"64x64", 64, 8},
                           {"32x32", 32, 8},
                           {"32x32, threshold 0", 32, 0},
                           {"32x32, threshold 32", 32, 32}}) {
    VdlsOptions options;
    options.leaves = v.leaves;
    options.merge_threshold = v.threshold;
    setups.push_back(vdls_setup(v.title, options));
    Scene drawn = scene.scene;
    drawn.rendering.vdls = options;
    lab.picture(drawn, camera, Engine::vdls);
    report.quadtrees.push_back(
        {v.title, fmt::format("images/{}-vdls.png", scene.id), lab.renderer.vdls().last_work().nodes});
  }
  report.series.push_back({"quadtrees", "Figure 6: quadtrees, of " + scene.title, "", {}, {}});
  report.series.back().points.push_back({1, "", lab.time(scene.scene, setups, 0.08)});
}

/// Section 4.3: layers a pass, with the early test and without it.
VdlsSeries study_layers(Lab& lab, const VdlsScene& scene) {
  VdlsSeries series{
      "layers", "Section 4.3: layers that a pass takes, of " + scene.title, "layers a pass", {}, {}};
  Points points;
  for (const int layers : {1, 2, 4, 8, 16, 32}) {
    VdlsOptions early, late, backwards;
    early.layers_per_pass = late.layers_per_pass = backwards.layers_per_pass = layers;
    late.early_test = false;
    backwards.back_to_front = true;
    points.add(layers, fmt::format("{}", layers),
               {scene.scene,
                lab.size,
                {vdls_setup("front to back", early), vdls_setup("without the early test", late),
                 vdls_setup("back to front", backwards)}});
  }
  series.points = points.timed(lab, 0.1);
  return series;
}

/// Figure 7: volumes of more and more points; figure 8: pictures of more and more pixels, rays of more and
/// more samples.
void study_scaling(VdlsReport& report, Lab& lab) {
  const auto setups = engine_setups();
  Points volumes, images, rates;
  for (const int n : {16, 32, 64, 128})
    volumes.add(n, fmt::format("{}", n),
                {builtin_surface_scene(fmt::format("gyroid?n={}", n)).scene, lab.size, setups});
  Scene scene = builtin_surface_scene("marschner-lobb?n=41").scene;
  scene.rendering.step = 0.5;
  for (const double share : {0.25, 0.5, 0.75, 1.0}) {
    const glm::ivec2 size = glm::max(glm::ivec2(share * glm::dvec2(lab.size)), glm::ivec2(1));
    images.add(double(size.x) * size.y, fmt::format("{}x{}", size.x, size.y), {scene, size, setups});
  }
  for (const double rate : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    scene.rendering.step = 1 / rate;
    rates.add(rate, fmt::format("{}", rate), {scene, lab.size, setups});
  }
  report.series.push_back({"volumes",
                           "Figure 7: the volume grows",
                           "points on an axis",
                           {{"points on an axis", 1}, {"points of the volume", 3}},
                           volumes.timed(lab, 0.1)});
  report.series.push_back({"images",
                           "Figure 8, left: the picture grows, two samples a voxel",
                           "pixels",
                           {{"pixels", 1}},
                           images.timed(lab, 0.1)});
  report.series.push_back({"rates",
                           "Figure 8, right: rays take more samples",
                           "samples a voxel",
                           {{"samples a voxel", 1}},
                           rates.timed(lab, 0.1)});
}

/// Figure 10: the post-shaded filters, of the paper's grey ramp; lookup of the surfaces' colours.
void study_filters(VdlsReport& report, Lab& lab, const VdlsScene& engine) {
  for (const auto& [blend_mode, name] : names_of<BlendMode>()) {
    Scene scene = engine.scene;
    scene.rendering.blend_mode = blend_mode;
    if (blend_mode != BlendMode::lookup) scene.tf = grey_ramp(scene.volume->statistics.range);
    if (blend_mode != BlendMode::iso_surface) scene.rendering.shading = Shading::none;
    report.filters.push_back(
        {std::string(name), picture_pair(report, lab, fmt::format("filter-{}", name), scene)});
  }
}

/// Figure 11: how far each way of rendering is from the exact integral.
void study_quality(VdlsReport& report, Lab& lab) {
  const VdlsScene phantom = phantom_scene();
  report.phantom = phantom.title;
  const Camera camera = whole_volume_camera(phantom.scene.volume->grid, aspect_of(lab.size));
  const Reference exact =
      render_reference(phantom.scene, camera, lab.size, Answer::integral, default_tolerance,
                       [&](double) { return !lab.stop.stop_requested(); });
  report.pictures.push_back({"images/phantom-exact.png", exact.image()});
  std::vector<std::string> post_features;
  const auto add = [&](std::string name, Engine engine, double rate, ClassificationMethod classification) {
    Scene scene = phantom.scene;
    scene.rendering.step = 1 / rate;
    scene.rendering.classification = classification;
    const Image image = lab.picture(scene, camera, engine);
    const auto features = lab.renderer.need(scene, camera, lab.size).features.in;
    if (is_preintegrated(classification) && features == post_features) return;  // it has no part
    post_features = features;
    const std::string picture = fmt::format("images/phantom-{}.png", report.quality.size());
    const std::string errors = fmt::format("images/phantom-{}-error.png", report.quality.size());
    report.quality.push_back({std::move(name), picture, errors, rate,
                              image_error(exact, image, {}, glm::vec3(scene.rendering.background)).compared});
    report.pictures.push_back({picture, image});
    report.pictures.push_back({errors, error_picture(exact, image)});
  };
  for (const double rate : {1.0, 2.0}) {
    add("VDLS", Engine::vdls, rate, ClassificationMethod::post);
    add("ray caster", Engine::raycaster, rate, ClassificationMethod::post);
    add("ray caster, pre-integration", Engine::raycaster, rate, ClassificationMethod::preintegrated);
  }
}

void study(VdlsReport& report, Lab& lab, const std::filesystem::path& folder) {
  const auto scenes = vdls_scenes(folder);
  study_table(report, lab, scenes);
  fmt::print(stderr, "figures 5 to 8\n");
  report.series.push_back(study_ranges(lab, scenes[2]));
  study_quadtrees(report, lab, scenes[5]);
  report.series.push_back(study_layers(lab, scenes[5]));
  study_scaling(report, lab);
  fmt::print(stderr, "figures 10 and 11\n");
  // A ramp leaves nothing of the engine's built-in stand-in, whose values are nearly all small
  study_filters(report, lab, scenes[scenes[4].title.starts_with("builtin:") ? 1 : 4]);
  study_quality(report, lab);
}

Json write_study(const VdlsReport& report, const std::filesystem::path& folder) {
  make_folder(folder / "images");
  const Json json = vdls_json(report);
  Json page = json;
  for (const auto& [name, image] : report.pictures) {
    write_image(folder / name, image, glm::vec3(0));
    page["pictures"][name] = data_address(folder / name);
  }
  write_file_atomically(folder / "vdls.json", print_json(json));
  write_page(folder / "vdls.html", "View-dependent layer sampling", web_file("vdls.html"),
             web_file("vdls.js"), page);
  return json;
}

}  // namespace

void run_vdls_study(const StudyOptions& options) {
  if (options.scene.has_any())
    throw Error("--study vdls has transfer functions and views of its own: no preset, mode or camera");
  VdlsReport report;
  report.command = options.command;
  report.made_at = utc_now();
  report.size = options.size.value_or(default_size);
  const OffscreenContext context(options.device);
  report.renderer = context.renderer();
  work_on_study(options, [&] {
    Lab lab{Renderer(), report.size, options.budget_seconds, options.stop};
    study(report, lab, options.data_folder);
  });
  const Json json = write_study(report, options.folder);
  print_study(options, json, (options.folder / "vdls.html").string() + "\n");
}

}  // namespace crest
