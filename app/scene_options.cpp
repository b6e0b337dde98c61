#include "app/scene_options.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <regex>

#include "app/load_with_progress.h"
#include "app/preset_source.h"
#include "app/sources.h"
#include "presets/error.h"
#include "presets/names.h"
#include "presets/number_text.h"
#include "presets/preset_file.h"
#include "render/files/load.h"
#include "render/files/time_steps.h"
#include "render/gl/render_target.h"
#include "render/scene/camera.h"
#include "render/scene/exact.h"
#include "render/volume/query.h"

namespace crest {
namespace {

/// "x,y,z" as a preset's field; each as people write numbers.
std::string triple(const std::string& path, const std::string& text) {
  std::string array;
  for (const std::string_view part : split(text, ',')) {
    const TypedNumber typed = read_number(part);
    array += fmt::format("{}{}", array.empty() ? "" : ",", typed.number ? exact_text(*typed.number) : part);
  }
  return fmt::format("{}=[{}]", path, array);
}

template <NamedEnum T>
std::vector<std::string> words_of() {
  std::vector<std::string> names;
  for (const auto& named : names_of<T>()) names.emplace_back(named.name);
  return names;
}

/// The preset with one field as an option says. A wrong field or value is a fault of the command line.
Preset with_field(const Preset& preset, const char* option, const std::string& assignment) {
  try {
    return set_field(preset, assignment);
  } catch (const Error& error) {
    throw UsageError(option, error.what());
  }
}

}  // namespace

void SceneOptions::add_to(Options options) {
  options
      .add("--preset", preset,
           "A preset's file, its name in the library (crest list presets), or a picture that was made with "
           "it; - is the "
           "standard input")
      .type_name("PRESET")
      .offers(library_names());
  options
      .add("--frame", frame,
           "Of a 4D file, or of a numbered list of files ('flow_*.vti'): which one, counted from 0")
      .type_name("N")
      .check([](const std::string& text) {
        const auto number = to_integer(text);
        const bool is_right = text == "all" || (number && *number >= 0 && *number < (1 << 30));
        return is_right ? "" : "a frame is a number from 0; render takes \"all\", too";
      });
  options.add("--mode", mode, "What a ray collects").type_name("MODE").one_of(words_of<Mode>());
  options.add("--engine", engine, "What renders").type_name("ENGINE").one_of(words_of<Engine>());
  options.add("--illumination", illumination, "What a sample contributes to its ray")
      .type_name("NAME")
      .one_of(words_of<BlendMode>());
  options.add("--step", step, "Step length, in units of the smallest spacing").type_name("STEP");
  options.add("--eye", eye, "Camera: where the eye is (world units)").type_name("X,Y,Z");
  options.add("--target", target, "Camera: what it looks at").type_name("X,Y,Z");
  options.add("--up", up, "Camera: what is up").type_name("X,Y,Z");
  options.add("--fov", fov, "Camera: vertical field of view in degrees").type_name("DEG");
  options.add("--projection", projection, "Camera: " + name_list<Projection>()).type_name("NAME");
  options.add("--set", sets, "Sets any field of the preset by its JSON path, as rendering.step=0.5")
      .type_name("PATH=VALUE")
      .one_value_each();  // one value each: what follows is VOLUME
  options.add_flag("--fit-range", fit_range, "Map the transfer function's span onto the volume's range");
}

std::vector<std::string> SceneOptions::option_names() {
  return {"--preset", "--frame", "--mode", "--engine",     "--illumination", "--step", "--eye",
          "--target", "--up",    "--fov",  "--projection", "--fit-range",    "--set"};
}

void SceneOptions::leave_out_unused(const Options& options) const {
  if (volume.empty() || volume.starts_with("builtin:")) options.leave_out({"--frame"});
}

bool SceneOptions::has_any() const {
  const auto is_given = [](const std::string& text) { return !text.empty(); };
  return fit_range || !sets.empty() ||
         std::ranges::any_of(
             std::array{preset, frame, mode, engine, illumination, step, eye, target, up, fov, projection},
             is_given);
}

std::string SceneOptions::source() const {
  if (frame.empty()) return volume;
  if (is_of_all_frames())
    throw UsageError("--frame", "one picture is of one frame: its number, counted from 0");
  return source_of_step(volume, std::stoi(frame));
}

std::shared_ptr<const Volume> SceneOptions::load() const {
  return std::make_shared<const Volume>(load_with_progress(source()));
}

bool SceneOptions::depends_on_range(const Preset& said) const {
  return fit_range || said.transfer_function.domain == Domain::normalized;
}

std::shared_ptr<const Volume> SceneOptions::in_range_of_steps(std::shared_ptr<const Volume> loaded,
                                                              const Preset& said) const {
  if (loaded->frames < 2 || !depends_on_range(said)) return loaded;
  auto wide = std::make_shared<Volume>(*loaded);
  widen_range(*wide, range_of_steps(volume, *loaded));
  return wide;
}

Preset SceneOptions::read_preset() const {
  Preset result;
  if (preset.empty())
    result.transfer_function = default_transfer_function();
  else
    result = load_preset_from(preset);
  for (const auto& set : sets) result = with_field(result, "--set", set);
  const auto set_if = [&](const char* option, const std::string& text, const std::string& assignment) {
    if (!text.empty()) result = with_field(result, option, assignment);
  };
  set_if("--mode", mode, "rendering.mode=" + mode);
  set_if("--engine", engine, "rendering.engine=" + engine);
  set_if("--illumination", illumination, "rendering.illumination=" + illumination);
  set_if("--step", step, "rendering.step=" + step);
  if (const std::string why_not = why_inconsistent(result.rendering); !why_not.empty())
    throw UsageError("--set", why_not);
  with_camera(result);  // a wrong one is found before there is a volume
  return result;
}

Preset SceneOptions::with_camera(Preset result) const {
  const auto set_if = [&](const char* option, const std::string& text, const std::string& assignment) {
    if (!text.empty()) result = with_field(result, option, assignment);
  };
  set_if("--eye", eye, triple("camera.eye", eye));
  set_if("--target", target, triple("camera.target", target));
  set_if("--up", up, triple("camera.up", up));
  set_if("--fov", fov, "camera.fov_y_degrees=" + fov);
  set_if("--projection", projection, "camera.projection=" + projection);
  return result;
}

Preset SceneOptions::for_volume(Preset result, const Volume& loaded, double aspect) const {
  if (!eye.empty() || !target.empty() || !up.empty() || !fov.empty() || !projection.empty()) {
    const bool is_fitted = !result.camera && eye.empty() && target.empty();
    result.camera = camera_of(result, loaded.grid, aspect);
    result = with_camera(std::move(result));
    if (is_fitted) {
      const Camera whole =
          whole_volume_camera(loaded.grid, aspect, result.camera->fov_y_degrees, result.camera->projection);
      result.camera->eye = whole.eye;
      result.camera->target = whole.target;
    }
  }
  if (fit_range && result.transfer_function.domain == Domain::data)
    result.transfer_function =
        remap_values(result.transfer_function, result.transfer_function.range(), loaded.statistics.range);
  return result;
}

Preset SceneOptions::read_preset(const Volume& loaded, double aspect) const {
  return for_volume(read_preset(), loaded, aspect);
}

void PictureOptions::add_to(Options options) {
  options
      .add("-o,--output", output,
           "The picture: .png (8 bit over the background) or .exr (32-bit float); - is the standard output")
      .required()
      .type_name("FILE");
  options.add("--format", format, "Of the picture, whatever its name; of the standard output png without it")
      .type_name("FORMAT")
      .one_of({"png", "exr"});
  options.add("--size", size, "Width x height in pixels").shows_default().type_name("WxH");
  options.add("--frames", frames, "Frames to time; the statistics have their median")
      .in(1, 100000)
      .shows_default();
  options.add("--device", device, "Graphics device (crest list devices); hardware first by default")
      .in(0, 1000);
  options.add_flag("--exact", exact,
                   "By the exact march: no crossing missed, whatever the preset's step and classification");
  options.add_flag("--json", json, "Print statistics as JSON");
}

void PictureOptions::check() const {
  if (is_to_stdout() && json)
    throw UsageError("--json", "the picture goes to the standard output: without --json, or -o FILE");
}

Preset PictureOptions::with_exact(Preset preset, bool in_all_modes) const {
  if (!exact) return preset;
  if (preset.rendering.engine == Engine::reference)
    throw UsageError("--exact", "rendering.engine is reference, the exact answer on the CPU: one of the two");
  Rendering drawn = preset.rendering;
  if (in_all_modes) drawn.mode = Mode::both;
  if (const std::string why_not = why_not_exact(drawn); !why_not.empty())
    throw UsageError("--exact", why_not);
  preset.rendering = exact_rendering(preset.rendering);
  return preset;
}

glm::ivec2 pixels_of(const std::string& size) {
  std::smatch match;
  static const std::regex form(R"(([1-9]\d{0,5})x([1-9]\d{0,5}))");
  if (!std::regex_match(size, match, form))
    throw UsageError("--size", fmt::format("'{}' is not WIDTHxHEIGHT, as in 512x512", size));
  const glm::ivec2 pixels(std::stoi(match[1]), std::stoi(match[2]));
  try {
    gl::require_size(pixels);
  } catch (const Error& error) {
    throw UsageError("--size", error.what());
  }
  return pixels;
}

}  // namespace crest
