// How long the device takes for a frame: the presets of the library on built-in volumes of n^3 points, by
// timer queries, at half a voxel. A line of JSON each on standard output, the device first, so that a run
// which is cut off loses little. Usage: bench_frames [--points N] [--size WxH] [--frames N] [--limit MS]
// [--device-only]
//
// `reads` is a loop over the samples of DVR that only reads the volume, shading and skipping off: the
// device's limit. `all_samples` is what DVR takes for the same samples.
#include <epoxy/gl.h>
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <string>

#include "app/offscreen_context.h"
#include "app/options.h"
#include "app/scene_options.h"
#include "presets/json.h"
#include "presets/preset_file.h"
#include "render/gl/filter_weights.h"
#include "render/gl/timer.h"
#include "render/measure/timing.h"
#include "render/raycaster/raycaster.h"
#include "render/scene/camera.h"
#include "render/volume/builtin.h"
#include "tests/benchmark/fetch_loop.h"

namespace crest::bench {
namespace {

using Json = nlohmann::ordered_json;

struct Settings {
  int points = 256, frames = 9, limit_ms = 2000;
  std::string size = "1024x1024", volume;
  bool device_only = false;
};

/// The presets in groups of one volume, so that each volume is made once.
const std::map<std::string, std::vector<const char*>> presets_by_volume{
    {"plume", {"dirac-shell", "fire"}},       {"gyroid", {"four-peaks", "step-surface"}},
    {"noise", {"smooth-haze", "noisy-band"}}, {"sphere", {"onion", "true-spike"}},
    {"marschner-lobb", {"glass-and-bone"}},   {"vessels", {"vessels-shell"}},
};

void print_line(const Json& line) {
  fmt::print("{}\n", line.dump());
  std::fflush(stdout);
}

std::string text_of(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

int limit_of(GLenum name) {
  GLint value = 0;
  glGetIntegerv(name, &value);
  return value;
}

Json device_json() {
  return {{"devices", list_devices()},
          {"vendor", text_of(GL_VENDOR)},
          {"renderer", text_of(GL_RENDERER)},
          {"version", text_of(GL_VERSION)},
          {"glsl", text_of(GL_SHADING_LANGUAGE_VERSION)},
          {"filter_weight_error", gl::measure_weight_error()},
          {"limits",
           {{"3d_texture_size", limit_of(GL_MAX_3D_TEXTURE_SIZE)},
            {"texture_size", limit_of(GL_MAX_TEXTURE_SIZE)},
            {"texture_units", limit_of(GL_MAX_TEXTURE_IMAGE_UNITS)},
            {"storage_block_bytes", limit_of(GL_MAX_SHADER_STORAGE_BLOCK_SIZE)}}}};
}

/// Median of some frames; fewer where they take long, none where a small picture tells that one takes longer
/// than the limit.
Json frame_times(Raycaster& raycaster, const Scene& scene, glm::ivec2 size, const Settings& settings) {
  constexpr int smaller = 8;
  constexpr double enough_ms = 1500;
  const Camera camera = whole_volume_camera(scene.volume->grid, double(size.x) / size.y);
  const glm::ivec2 small = (size + smaller - 1) / smaller;
  gl::RenderTarget small_target(small, false);
  raycaster.draw(scene, camera, small_target);  // uploads and compiles
  glFinish();
  const double expected_ms =
      smaller * smaller * gl::device_ms([&] { raycaster.draw(scene, camera, small_target); });
  if (expected_ms > settings.limit_ms) return {{"too_slow_about_ms", expected_ms}};
  gl::RenderTarget target(size, false);
  gl::device_ms([&] { raycaster.draw(scene, camera, target); });
  std::vector<double> all;
  for (double sum = 0; int(all.size()) < settings.frames && sum < enough_ms; sum += all.back())
    all.push_back(gl::device_ms([&] { raycaster.draw(scene, camera, target); }));
  return {{"ms", median(all)},
          {"least_ms", std::ranges::min(all)},
          {"most_ms", std::ranges::max(all)},
          {"frames", all.size()}};
}

/// One kind of frame of a preset.
struct Variant {
  const char* name;
  Mode mode;
  ClassificationMethod classification = ClassificationMethod::post;
  bool all_samples = false;  ///< shading and skipping off
  bool only_reads = false;
  Filter filter = Filter::linear;
};

constexpr Variant variants[] = {
    {"DVR_ONLY", Mode::dvr_only},
    {"PEAK_XOR_DVR", Mode::peak_xor_dvr},
    {"analytic", Mode::peak_xor_dvr, ClassificationMethod::analytic},
    {"all_samples", Mode::dvr_only, ClassificationMethod::post, true},
    {"linear_exact", Mode::dvr_only, ClassificationMethod::post, true, false, Filter::linear_exact},
    {"reads", Mode::dvr_only, ClassificationMethod::post, true, true},
};

void measure(const std::string& volume_name, glm::ivec2 size, const Settings& settings,
             const std::filesystem::path& reading_shaders) {
  const std::string source = fmt::format("{}?n={}", volume_name, settings.points);
  const double begin = steady_seconds();
  const auto volume = std::make_shared<const Volume>(make_builtin(source));
  const double made_s = steady_seconds() - begin;
  const auto resources = std::make_shared<Resources>(),
             reading = std::make_shared<Resources>(reading_shaders);
  for (const char* preset : presets_by_volume.at(volume_name)) {
    Json line{{"volume", source}, {"made_s", made_s}, {"preset", preset}, {"size", settings.size}};
    for (const Variant& variant : variants) {
      Scene scene = make_scene(volume, load_preset(preset));
      scene.rendering.mode = variant.mode;
      scene.rendering.classification = variant.classification;
      scene.rendering.step = 0.5;
      scene.rendering.filter = variant.filter;
      if (variant.all_samples) {
        scene.rendering.shading = Shading::none;
        scene.rendering.skipping = false;
        scene.rendering.early_termination = 0;
      }
      try {
        Raycaster raycaster(variant.only_reads ? reading : resources);
        line[variant.name] = frame_times(raycaster, scene, size, settings);
      } catch (const std::exception& error) {
        line[variant.name] = {{"error", error.what()}};
      }
    }
    print_line(line);
  }
}

int run(const Settings& settings) {
  const OffscreenContext context;
  print_line(device_json());
  if (settings.device_only) return 0;
  const glm::ivec2 size = pixels_of(settings.size);
  const ChangedShaders reading = fetch_loop();
  for (const auto& [volume, presets] : presets_by_volume)
    if (settings.volume.empty() || settings.volume == volume)
      measure(volume, size, settings, reading.folder());
  return 0;
}

int main_with(int argc, char** argv) {
  Settings settings;
  CommandLine line({"How long the device takes for a frame", "", ""});
  Options options = line.options();
  options.add("--points", settings.points, "Points of a volume on each axis").in(2, 4096);
  options.add("--size", settings.size, "Width x height of a picture").type_name("WxH");
  options.add("--frames", settings.frames, "Frames that a median is taken of").in(1, 1000);
  options.add("--limit", settings.limit_ms, "Milliseconds; what takes longer a frame is left out")
      .in(1, 1000000);
  options.add("--volume", settings.volume, "One of the built-in volumes alone").type_name("NAME");
  options.add_flag("--device-only", settings.device_only, "Only the device");
  options.when_read([] {});
  if (!line.read(argc, argv)) return 0;
  return run(settings);
}

}  // namespace
}  // namespace crest::bench

int main(int argc, char** argv) {
  try {
    return crest::bench::main_with(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_frames: %s\n", error.what());
    return 1;
  }
}
