#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <thread>

#include "app/commands.h"
#include "app/compare.h"
#include "app/file_watch.h"
#include "app/frame_log.h"
#include "app/idle_memory.h"
#include "app/layout_file.h"
#include "app/preset_source.h"
#include "app/scene_options.h"
#include "app/sources.h"
#include "app/studio.h"
#include "app/studio_settings.h"
#include "app/unknown_word.h"
#include "app/window.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/number_text.h"
#include "presets/preset_file.h"
#include "presets/printable.h"
#include "render/files/file_request.h"
#include "render/files/load.h"

namespace crest {
namespace {

struct StudioOptions {
  SceneOptions scene;
  std::string shader_folder, frame_log, layout_file, scale, theme;
  bool watch = false;
};

/// What the window is drawn with.
struct Look {
  float scale;
  Theme theme;
  bool operator==(const Look&) const = default;
};

/// What was kept, with what the command line says for this run.
ReadSettings settings_for(const StudioOptions& options) {
  ReadSettings read = read_settings(settings_file());
  if (!options.scale.empty()) read.settings.scale = read_number(options.scale).number;
  if (!options.theme.empty()) read.settings.theme = *theme_named(options.theme);
  return read;
}

constexpr double interactive_ms = 3;  ///< for the views, in a frame in which the person acts: it stays live
constexpr double interactive_share = 0.25;  ///< or of the last frame: where the window itself takes long
constexpr double most_interactive_ms = 30;
constexpr double resting_ms = 80;
constexpr double rest_after_s = 0.25;       ///< since the last input
constexpr int settling_frames = 3;          ///< that Dear ImGui takes to show what an input did
constexpr double counting_pause_s = 0.004;  // between looks at what the device counts

Document initial_document(const StudioOptions& options) {
  Document document;
  document.volume_source = options.scene.source();
  document.preset = options.scene.read_preset();
  const std::string& preset = options.scene.preset;
  const bool says_shading = std::ranges::any_of(
      options.scene.sets, [](const std::string& set) { return set.starts_with("rendering.shading"); });
  if (preset.empty() && !says_shading) document.preset.rendering.shading = new_preset().rendering.shading;
  if (is_picture_file(preset) || options.scene.is_preset_from_stdin())
    return document;  // which is not what is saved into
  if (std::filesystem::exists(preset))
    document.preset_path = preset;
  else
    document.library_name = preset;
  return document;
}

void run_frames(const StudioOptions& options, Window& window, Studio& studio) {
  using Clock = std::chrono::steady_clock;
  FrameLog log;
  LayoutFile layout(options.layout_file);
  FileWatch preset_watch;
  IdleMemory memory;
  std::optional<Look> look;
  Clock::time_point last_input = Clock::now();
  int settling = settling_frames;
  double frame_ms = 0;
  while (!studio.wants_to_quit()) {
    // At rest the program sleeps; while a volume is read, or something is measured, it looks up now and then
    const bool works = settling > 0 || studio.is_drawing();
    const double pause = studio.is_loading() || studio.is_stepping() ? 0.05
                         : studio.is_measuring() || options.watch    ? 0.2
                                                                     : 1.0;
    if (studio.awaits_counts())
      window.poll_events(true, counting_pause_s);
    else
      window.poll_events(!works, studio.animates() ? std::min(pause, blink_s / 4) : pause);
    studio.keep_unsaved_changes();
    if (options.watch && preset_watch.has_changed({studio.document().preset_path})) {
      studio.take_changed_preset();
      settling = settling_frames;
    }
    const auto begin = Clock::now();
    const std::clock_t processor_begin = std::clock();
    if (window.had_input()) {
      last_input = begin;
      settling = settling_frames;
    }
    if (settling <= 0 && !studio.is_drawing() && !studio.is_loading() && !studio.has_news() &&
        !studio.animates()) {
      if (!studio.is_measuring()) memory.rest(begin, last_input);
      continue;
    }
    memory.note_work();
    const bool interactive =
        window.is_mouse_down() || begin - last_input < std::chrono::duration<double>(rest_after_s);

    const StudioSettings& settings = studio.settings();
    const Look wanted{settings.scale ? float(*settings.scale) : window.content_scale(), settings.theme};
    if (look != wanted) {
      window.set_style(wanted.scale, wanted.theme);
      look = wanted;
    }
    window.begin_frame();
    for (const auto& dropped : window.take_dropped()) studio.open(dropped);
    const double moving_ms = std::clamp(interactive_share * frame_ms, interactive_ms, most_interactive_ms);
    studio.frame(window.take_close_request(), interactive ? moving_ms : resting_ms, interactive);
    window.end_frame();
    window.set_title(studio.title());
    if (settling > 0 && !studio.is_drawing() && !studio.is_loading()) --settling;

    frame_ms = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    studio.set_performance_text(fmt::format("{:.0f} ms a frame", frame_ms));
    const double processor_ms = 1e3 * double(std::clock() - processor_begin) / CLOCKS_PER_SEC;
    if (window.is_mouse_down()) log.add_frame(frame_ms, processor_ms);
    log.add_versions(begin, studio.views().wanted_versions(), studio.views().shown_versions());
    layout.update(studio);
  }
  if (!options.frame_log.empty()) write_file_atomically(options.frame_log, log.summary());
}

/// The window until it is closed. Quitting waits for no thread: where one still
/// reads a volume, the program ends without taking apart what the thread uses.
void run_window(const StudioOptions& options) {
  Document document = initial_document(options);
  const ReadSettings settings = settings_for(options);
  Window window("Crest", 1720, 1160, settings.settings.scale);
  Studio studio(
      std::move(document),
      [scene = options.scene](Preset preset, const Volume& volume, double aspect) {
        return scene.for_volume(std::move(preset), volume, aspect);
      },
      options.shader_folder);
  studio.use_settings(settings);
  try {
    run_frames(options, window, studio);
  } catch (const std::exception& error) {
    if (!studio.leaves_thread()) throw;
    studio.finish_writing();
    fmt::print(stderr, "crest: {}\n", printable(error.what()));
    std::_Exit(1);
  }
  if (!studio.leaves_thread()) return;
  studio.finish_writing();
  std::_Exit(0);
}

void open_studio(const StudioOptions& options) {
  // What is not there is told before a window opens, as reading it does
  if (const std::string source = options.scene.source(); !source.empty() && !is_volume_there(source))
    load_volume(source);
  run_window(options);
}

void require_logs(const StudioOptions& options) {
  require_other_files({{"--log-frames", options.frame_log}, {"--log-layout", options.layout_file}},
                      {options.scene.volume, options.scene.preset});
  for (const auto& log : {options.frame_log, options.layout_file})
    if (!log.empty()) require_writable(log);
}

/// A word that stands alone could be a mistyped command.
void expect_volume(const OptionTable& table, const std::string& source) {
  if (source.find_first_of("./:?") == source.npos && !is_volume_there(source))
    throw UsageError("VOLUME", fmt::format("'{}' is neither a command nor a file or folder{}", source,
                                           meant_command(table, source)));
}

/// What the studio does where it has no display: a picture instead of a window.
void run_without_display(StudioOptions options) {
  CompareOptions compare;
  compare.scene = options.scene;
  if (compare.scene.volume.empty()) compare.scene.volume = "builtin:plume?n=96";
  if (compare.scene.preset.empty()) compare.scene.preset = "dirac-shell";
  compare.picture.output = "crest-modes.png";
  compare_modes(compare);
  fmt::print(
      "No display here: the four modes of {} with preset {} are in {}.\n"
      "For the window, run this where DISPLAY is set (a desktop, ssh -X, or xvfb-run).\n",
      compare.scene.volume, compare.scene.preset, std::filesystem::absolute(compare.picture.output).string());
}

}  // namespace

namespace {

/// A preset may stand where the volume does, as when one is opened from a file manager.
void take_preset_for_volume(SceneOptions& scene) {
  std::error_code ignored;
  if (!scene.preset.empty() || extension_of(scene.volume) != ".json") return;
  if (std::filesystem::is_regular_file(scene.volume, ignored)) std::swap(scene.preset, scene.volume);
}

void add_studio_options(Options to, StudioOptions& options) {
  to.add("VOLUME", options.scene.volume, "What to open; a preset's .json may stand here, too")
      .offers(builtin_sources());
  options.scene.add_to(to);
  to.add_flag("--watch", options.watch,
              "Take over the preset whenever its file changes, while nothing is unsaved here");
  to.add("--shaders", options.shader_folder, "Read the shaders from this folder; F5 reads them again")
      .existing_folder();
  to.add("--scale", options.scale, "Size of texts and controls in this run's window, 0.75 to 3")
      .type_name("FACTOR")
      .check([](const std::string& text) {
        const TypedNumber typed = read_number(text);
        return typed.number ? why_outside(*typed.number, scale_rule) : typed.wrong;
      });
  to.add("--theme", options.theme, "Colours of this run's window").one_of({"dark", "light"});
  to.add("--log-frames", options.frame_log, "On quitting, write frame times and edit-to-view times here")
      .type_name("FILE");
  to.add("--log-layout", options.layout_file,
         "Write where the widgets are, for scripts that drive the window")
      .type_name("FILE");
}

}  // namespace

void add_studio(Options app, Command& chosen) {
  auto options = std::make_shared<StudioOptions>();
  const auto run = [options] {
    require_logs(*options);
    has_display() ? open_studio(*options) : run_without_display(*options);
  };
  add_studio_options(app, *options);
  app.when_read([options, run, &chosen, app] {
    if (app.has_command()) return;
    take_preset_for_volume(options->scene);
    options->scene.leave_out_unused(app);
    if (!options->scene.volume.empty()) expect_volume(app.table(), options->scene.volume);
    chosen = run;
  });
  Options command = app.add_command("window", "The studio; also without this word: crest [VOLUME]", "Look");
  command.add_example("crest head.nrrd --preset dirac-shell");
  add_studio_options(command, *options);
  command.when_read([options, run, command, &chosen] {
    take_preset_for_volume(options->scene);
    options->scene.leave_out_unused(command);
    chosen = run;
  });
}

}  // namespace crest
