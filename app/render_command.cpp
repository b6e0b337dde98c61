#include <fmt/core.h>

#include <chrono>
#include <thread>

#include "app/auto_choice.h"
#include "app/cache_folder.h"
#include "app/commands.h"
#include "app/exact_picture.h"
#include "app/file_watch.h"
#include "app/offscreen_context.h"
#include "app/picture.h"
#include "app/picture_maker.h"
#include "app/picture_output.h"
#include "app/preset_source.h"
#include "app/progress.h"
#include "app/scene_options.h"
#include "app/sources.h"
#include "presets/atomic_file.h"
#include "presets/json.h"
#include "presets/json_text.h"
#include "presets/printable.h"
#include "render/measure/probe_scene.h"
#include "render/measure/timing.h"
#include "render/scene/camera.h"
#include "render/scene/error_colors.h"
#include "render/scene/exact.h"

namespace crest {
namespace {

struct RenderOptions {
  SceneOptions scene;
  PictureOptions picture;
  std::string error_bound;  ///< where to write it; empty: nowhere
  AutoOptions automatic;
  int turntable = 1;  ///< pictures of one turn
  bool watch = false;
  Preset preset;  ///< which the pictures keep
};

/// How far each pixel may be off: as it is for an .exr, else in the colours of all error pictures.
Image error_bound_picture(const std::vector<float>& bounds, glm::ivec2 size, bool in_colors) {
  Image picture{size, {}};
  for (const float bound : bounds)
    picture.pixels.emplace_back(in_colors ? error_color(double(bound)) : glm::vec3(bound), 1);
  return picture;
}

void print_statistics(nlohmann::ordered_json json, const std::string& renderer) {
  json["renderer"] = renderer;
  fmt::print("{}\n", pretty(json));
}

MeasuredPicture draw_and_write(Renderer& renderer, const Scene& scene, const Camera& camera,
                               const RenderOptions& all) {
  const PictureOptions& options = all.picture;
  const std::filesystem::path bound_file = all.error_bound;
  const bool counts = options.json || !bound_file.empty();
  auto picture = measure_pictures(renderer, {scene}, camera, options.pixels(), options.frames, counts)[0];
  write_picture(options, picture.image, scene.rendering.background, preset_for_picture(all.preset, camera));
  if (!bound_file.empty())
    write_image(bound_file,
                error_bound_picture(picture.error_bounds, options.pixels(), bound_file.extension() != ".exr"),
                glm::vec3(0));
  print_warnings(picture.warnings);
  return picture;
}

void render_on_gpu(const Scene& scene, const Camera& camera, const RenderOptions& all) {
  const OffscreenContext context(all.picture.device);
  Renderer renderer({}, program_folder());
  const auto picture = draw_and_write(renderer, scene, camera, all);
  print_notes(picture.notes);
  if (all.picture.json) print_statistics(statistics_json(picture, renderer, scene), context.renderer());
}

/// One turn about what the camera looks at, in numbered files.
void render_turn(const Scene& scene, const Camera& camera, const RenderOptions& all) {
  const OffscreenContext context(all.picture.device);
  Renderer renderer({}, program_folder());
  for (int i = 0; i < all.turntable; ++i) {
    RenderOptions one = all;
    one.picture.output = numbered(all.picture.output, i, all.turntable).string();
    draw_and_write(renderer, scene, turned(camera, i, all.turntable), one);
  }
}

void render_on_cpu(const Scene& scene, const Camera& camera, const RenderOptions& render_options) {
  const PictureOptions& options = render_options.picture;
  const auto picture = render_exact_pictures({scene}, camera, options.pixels(), options.output)[0];
  write_picture(options, picture.reference.image(), scene.rendering.background,
                preset_for_picture(render_options.preset, camera));
  print_warnings(picture.warnings);
  print_notes(picture.notes);
  if (options.json) print_statistics(statistics_json(picture, scene), exact_renderer);
}

/// With the setting that suits scene and view: see choose_setting().
void render_as_chosen(Scene scene, const Camera& camera, const RenderOptions& all) {
  const PictureOptions& options = all.picture;
  const OffscreenContext context(options.device);
  const auto renderer = std::make_shared<Renderer>(std::filesystem::path(), program_folder());
  renderer->hold(scene.volume);
  const ChoiceSettings settings = all.automatic.settings();
  const glm::ivec2 size = options.pixels();
  const Choice choice = *choose_setting(scene, size, probe_scene(renderer, scene, camera, size), settings);
  scene.rendering = choice.rendering;
  const auto picture = draw_and_write(*renderer, scene, camera, all);
  auto notes = picture.notes;
  if (!choice.meets_target || !choice.fits_budget) notes.push_back("--auto: " + choice.why);
  if (const double residual = scene.rendering.early_termination; residual > 0)
    notes.push_back(
        fmt::format("--auto: what early_termination {:g} leaves out is not in the error foretold", residual));
  print_notes(notes);
  if (!options.json) {
    fmt::print(options.is_to_stdout() ? stderr : stdout, "{}\n",
               choice_line(choice, settings.target, median(picture.frame_ms)));
    return;
  }
  auto json = statistics_json(picture, *renderer, scene);
  json["auto"] = choice_json(choice, settings);
  print_statistics(json, context.renderer());
}

using SharedVolume = std::shared_ptr<const Volume>;

/// What is wrong with the size, or with where the picture goes, is found before any work.
SharedVolume read_volume(const RenderOptions& options) {
  options.picture.pixels();
  require_output(options.picture);
  std::vector<OutputFile> outputs;
  for (int i = 0; i < options.turntable; ++i)
    outputs.push_back({"--output", numbered(options.picture.output, i, options.turntable)});
  outputs.push_back({"--error-bound", options.error_bound});
  require_other_files(outputs, {options.scene.volume, options.scene.preset});
  for (const OutputFile& output : outputs)
    if (options.turntable > 1 && !output.path.empty()) require_writable(output.path);
  if (!options.error_bound.empty()) require_picture_file(options.error_bound);
  return options.scene.load();
}

/// A volume, and the same in the range of its time steps, once a preset asked for that: all are read for it.
struct LoadedVolume {
  SharedVolume volume, in_range_of_steps = nullptr;
};

SharedVolume for_preset(const SceneOptions& options, LoadedVolume& loaded, const Preset& said) {
  if (!options.depends_on_range(said)) return loaded.volume;
  if (!loaded.in_range_of_steps) loaded.in_range_of_steps = options.in_range_of_steps(loaded.volume, said);
  return loaded.in_range_of_steps;
}

void render_picture(RenderOptions options, LoadedVolume& loaded) {
  const double aspect = aspect_of(options.picture.pixels());
  const Preset said = options.scene.read_preset();
  const SharedVolume volume = for_preset(options.scene, loaded, said);
  const Preset preset = options.picture.with_exact(options.scene.for_volume(said, *volume, aspect));
  if (!options.error_bound.empty() && !is_exact(preset.rendering))
    throw UsageError("--error-bound", "only the exact march knows how far it may be off: add --exact");
  const Scene scene = make_scene(volume, preset);
  const Camera camera = camera_of(preset, volume->grid, aspect);
  options.preset = preset;
  if (options.turntable > 1) return render_turn(scene, camera, options);
  if (options.automatic.is_on) return render_as_chosen(scene, camera, options);
  if (options.watch && preset.rendering.engine == Engine::reference)
    throw UsageError("--watch", "the exact answer on the CPU takes too long for it: another --engine");
  const auto render = preset.rendering.engine == Engine::reference ? render_on_cpu : render_on_gpu;
  render(scene, camera, options);
}

/// Each time step, by the camera for the first one, in files with its number.
void render_steps(const RenderOptions& all) {
  RenderOptions one = all;
  one.scene.frame = "0";
  SharedVolume volume = read_volume(one);
  const int count = volume->frames;
  const auto output = [&](int step) {
    return count > 1 ? with_number(all.picture.output, step, count - 1).string() : all.picture.output;
  };
  std::vector<OutputFile> outputs;
  for (int i = 0; i < count; ++i) outputs.push_back({"--output", output(i)});
  require_other_files(outputs, {all.scene.volume, all.scene.preset});
  const Preset said = all.scene.read_preset();
  const ValueRange range = all.scene.in_range_of_steps(volume, said)->statistics.range;
  const double aspect = aspect_of(all.picture.pixels());
  const bool is_exact_answer = said.rendering.engine == Engine::reference;
  std::optional<OffscreenContext> context;
  std::optional<Renderer> renderer;
  if (!is_exact_answer) {
    context.emplace(all.picture.device);
    renderer.emplace(std::filesystem::path(), program_folder());
  }
  std::optional<Camera> camera;
  for (int i = 0; i < count; ++i) {
    one.scene.frame = fmt::format("{}", i);
    auto step = std::make_shared<Volume>(i == 0 ? *volume : *one.scene.load());
    volume.reset();
    widen_range(*step, range);
    one.preset = all.picture.with_exact(all.scene.for_volume(said, *step, aspect));
    if (!camera) camera = camera_of(one.preset, step->grid, aspect);
    one.picture.output = output(i);
    const Scene scene = make_scene(step, one.preset);
    if (is_exact_answer)
      render_on_cpu(scene, *camera, one);
    else
      draw_and_write(*renderer, scene, *camera, one);
  }
}

/// Once more whenever the preset's or the volume's file has changed, until Ctrl-C.
void render_and_watch(const RenderOptions& options) {
  constexpr std::chrono::milliseconds between_looks{100};
  FileWatch preset_watch, volume_watch;
  const auto preset_file = files_of(options.scene.preset), volume_file = files_of(options.scene.volume);
  if (preset_file.empty() && volume_file.empty())
    throw UsageError("--watch", "neither the preset nor the volume is a file that could change");
  preset_watch.has_changed(preset_file);
  volume_watch.has_changed(volume_file);
  const Interrupt interrupt;
  LoadedVolume loaded{read_volume(options)};
  const auto draw = [&] {
    render_picture(options, loaded);
    fmt::print(stderr, "crest: {} is drawn; waiting for changes (Ctrl-C ends)\n", options.picture.output);
  };
  draw();
  while (!interrupt.is_requested()) {
    std::this_thread::sleep_for(between_looks);
    const bool is_volume_new = volume_watch.has_changed(volume_file);
    if (!preset_watch.has_changed(preset_file) && !is_volume_new) continue;
    try {
      if (is_volume_new) loaded = {read_volume(options)};
      draw();
    } catch (const std::exception& error) {
      fmt::print(stderr, "crest: {}\n", printable(error.what()));  // what was drawn last stays
    }
  }
}

void yield_to_typed(const RenderOptions& options, Options command) {
  if (options.picture.is_to_stdout()) command.leave_out({"--json", "--turntable", "--watch"});
  const bool has_files = !files_of(options.scene.preset).empty() || !files_of(options.scene.volume).empty();
  if (options.scene.is_preset_from_stdin() || !has_files) command.leave_out({"--watch"});
  command.prefer_typed("--auto", {"--step", "--engine", "--exact", "--error-bound", "--turntable"});
  command.prefer_typed("--turntable", {"--json", "--error-bound"});
  options.scene.leave_out_unused(command);
  if (!options.automatic.is_on) command.leave_out({"--target-error", "--budget"});
}

}  // namespace

void add_render_command(Options app, Command& chosen) {
  auto options = std::make_shared<RenderOptions>();
  Options command = app.add_command("render", "Render one picture", "Pictures");
  command.add("VOLUME", options->scene.volume, "What to render (crest --help)")
      .required()
      .offers(builtin_sources());
  options->scene.add_to(command);
  options->picture.add_to(command);
  command
      .add(
          "--error-bound", options->error_bound,
          "With --exact: a picture of how far each pixel may be off, at most; .png in colours, .exr as it is")
      .type_name("FILE");
  command
      .add("--turntable", options->turntable,
           "So many pictures of one turn about what the camera looks at: OUTPUT-001.png, ...")
      .in(1, 3600)
      .type_name("N");
  command.add_flag("--watch", options->watch,
                   "Draw it again whenever the preset's or the volume's file changes, until Ctrl-C");
  options->automatic.add_to(command);
  command.add_example("crest render builtin:plume --preset dirac-shell -o plume.png");
  command.add_example("crest render head.nrrd --preset my.json --mode PEAK_ONLY --size 800x600 -o head.exr");
  command.add_example("crest render 'flow_*.vti' --preset my.json --frame all -o flow.png");
  command.add_example("crest render builtin:sphere --preset onion --eye -2,-4,1.5 --up 0,0,1 -o onion.png");
  command.when_read([options, command, &chosen] {
    yield_to_typed(*options, command);
    options->picture.check();
    const bool all_frames = options->scene.is_of_all_frames(), several = all_frames || options->turntable > 1;
    const char* which = all_frames ? "--frame" : "--turntable";
    if (options->picture.is_to_stdout() && (several || options->watch))
      throw UsageError(options->watch ? "--watch" : which, "the standard output takes one picture");
    if (all_frames && (options->turntable > 1 || options->watch))
      throw UsageError("--frame", "all frames: without --turntable and --watch");
    options->automatic.check(options->scene);
    if (options->watch && options->scene.is_preset_from_stdin())
      throw UsageError("--watch", "the standard input is read once: a preset's file, or its name");
    if (const std::filesystem::path bound = options->error_bound;
        !bound.empty() && bound.extension() != ".png" && bound.extension() != ".exr")
      throw UsageError("--error-bound", "takes a .png or an .exr");
    if (options->automatic.is_on && options->picture.exact)
      throw UsageError("--auto", "--exact is a choice of its own: one of the two");
    if (options->automatic.is_on && !options->error_bound.empty())
      throw UsageError("--error-bound", "of --exact alone, not of --auto");
    if (several && (options->picture.json || !options->error_bound.empty() || options->automatic.is_on))
      throw UsageError(which, "takes pictures alone: without --json, --error-bound and --auto");
    chosen = [options] {
      if (options->scene.is_of_all_frames())
        render_steps(*options);
      else if (options->watch)
        render_and_watch(*options);
      else {
        LoadedVolume loaded{read_volume(*options)};
        render_picture(*options, loaded);
      }
    };
  });
}

}  // namespace crest
