#include <fmt/core.h>

#include <charconv>
#include <chrono>

#include "app/auto_choice.h"
#include "app/commands.h"
#include "app/offscreen_context.h"
#include "app/output_folder.h"
#include "app/progress.h"
#include "app/report/page.h"
#include "app/report/progress_line.h"
#include "app/report/report_files.h"
#include "app/report/studies.h"
#include "app/scene_options.h"
#include "app/sources.h"
#include "app/unknown_word.h"
#include "presets/error.h"
#include "presets/json.h"
#include "presets/names.h"
#include "presets/number_text.h"
#include "presets/preset_file.h"
#include "render/scene/camera.h"

namespace crest {
namespace {

struct ReportOptions {
  SceneOptions scene;
  std::string output, size = "256x256", study, data_folder, budget = "120s",
                      target = to_string(default_target()), seed = "1";
  int device = -1;
  bool json = false, size_is_given = false, budget_is_given = false, seed_is_given = false;
  std::string command;  ///< as typed
};

/// "120s", "2m", "1.5h", "90"; "none" is without a limit.
std::optional<double> budget_seconds(const std::string& text) {
  if (text == "none") return std::nullopt;
  const double unit = text.ends_with('h') ? 3600 : text.ends_with('m') ? 60 : 1;
  const bool has_unit = unit > 1 || text.ends_with('s');
  const TypedNumber typed = read_number(text.substr(0, text.size() - (has_unit ? 1 : 0)));
  if (!typed.number || *typed.number <= 0 || *typed.number >= 1e9)
    throw UsageError("--budget", fmt::format("'{}' is not a time, as in 90s, 2m or 1h, nor 'none'", text));
  return unit * *typed.number;
}

std::uint64_t seed_of(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (text.empty() || fault != std::errc{} || end != text.data() + text.size())
    throw UsageError("--seed", fmt::format("'{}' is not a whole number from 0 to 2^64 - 1", text));
  return seed;
}

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const Study& study : studies()) names.emplace_back(study.name);
  return names;
}

const Study& find_study(const std::string& name) {
  for (const Study& study : studies())
    if (study.name == name) return study;
  throw UsageError("--study", why_not_one_of(name, study_names()));
}

/// The command that renders what the report is of, with these settings. `written` are those that it would
/// have otherwise.
std::string render_command(const SceneOptions& scene, const std::string& size, const Rendering& written,
                           const Rendering& settings) {
  std::string text = "crest render " + shell_word(scene.volume);
  const auto add = [&](const char* option, const std::string& value) {
    if (!value.empty()) text += fmt::format(" {} {}", option, shell_word(value));
  };
  add("--preset", scene.preset);
  add("--eye", scene.eye);
  add("--target", scene.target);
  add("--up", scene.up);
  add("--frame", scene.frame);
  add("--fov", scene.fov);
  add("--projection", scene.projection);
  for (const std::string& assignment : scene.sets) add("--set", assignment);
  for (const std::string& assignment : assignments_between(written, settings)) add("--set", assignment);
  add("--size", size);
  return text + (scene.fit_range ? " --fit-range" : "") + " -o picture.png";
}

Report subject_of(const ReportOptions& options) {
  Report report;
  report.size = pixels_of(options.size);
  report.settings.budget_seconds = budget_seconds(options.budget);
  report.settings.target = target_option(options.target);
  const auto loaded = options.scene.load();
  const Preset said = options.scene.read_preset();
  const auto volume = options.scene.in_range_of_steps(loaded, said);
  const Preset preset = options.scene.for_volume(said, *volume, aspect_of(report.size));
  report.scene = make_scene(volume, preset);
  if (const std::string why = why_without_answer(preset.rendering); !why.empty()) throw Error(why);
  report.camera = camera_of(preset, volume->grid, aspect_of(report.size));
  report.subject.command = options.command;
  report.subject.volume = options.scene.volume;
  report.subject.preset = options.scene.preset;
  report.subject.made_at = utc_now();
  SceneOptions plain = options.scene;  // what a method decides need not be said
  plain.mode = plain.engine = plain.step = "";
  report.subject.render_command = [plain, written = plain.read_preset().rendering, size = options.size,
                                   own = report.scene.rendering](const Method& method, double step) {
    return render_command(plain, size, written, measured_rendering(method, step, own));
  };
  return report;
}

void make_report(const ReportOptions& options, std::stop_token stop) {
  Report report = subject_of(options);
  const OffscreenContext context(options.device);
  report.subject.renderer = context.renderer();
  {
    ProgressLine progress(report.settings.budget_seconds);
    const auto begin = std::chrono::steady_clock::now();
    measure_report(report, stop, [&](std::string_view doing, double done) {
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
      progress.show(doing, done, report.points.size(), taken.count());
    });
  }
  const std::filesystem::path folder = options.output;
  if (report.points.empty())
    throw Error(fmt::format("{}: nothing was measured: {}", folder.string(),
                            stop.stop_requested() ? "stopped before the first point"
                            : report.left_out.empty()
                                ? "no method is left"
                                : report.left_out.front().what + ": " + report.left_out.front().why));
  const Json json = write_report(report, folder);
  if (options.json) fmt::print("{}", print_json(json));
  if (report.stopped)
    throw Error(fmt::format("stopped after {} points; {} has what was measured", report.points.size(),
                            (folder / "report.html").string()));
  if (!options.json) fmt::print("{}\n", (folder / "report.html").string());
}

void run_study(const ReportOptions& options, std::stop_token stop) {
  StudyOptions study_options;
  study_options.folder = options.output;
  study_options.scene = options.scene;
  if (options.size_is_given) study_options.size = pixels_of(options.size);
  if (options.budget_is_given) study_options.budget_seconds = budget_seconds(options.budget);
  study_options.data_folder = options.data_folder;
  study_options.device = options.device;
  study_options.seed = seed_of(options.seed);
  study_options.json = options.json;
  study_options.command = options.command;
  study_options.stop = stop;
  find_study(options.study).run(study_options);
}

void run_report(const ReportOptions& options) {
  pixels_of(options.size);  // a wrong one is found before any work
  const Interrupt interrupt;
  const OutputFolder folder(options.output);
  if (options.study.empty())
    make_report(options, interrupt.token());
  else
    run_study(options, interrupt.token());
}

std::string studies_with_seed() {
  std::string names;
  for (const Study& study : studies())
    if (study.takes_seed) names += (names.empty() ? "" : ", ") + std::string(study.name);
  return names;
}

/// Throws UsageError where one is wrong, or has no part in what is asked for.
void check_options(const ReportOptions& options) {
  if (options.scene.is_preset_from_stdin())
    throw UsageError("--preset", "a report says what it is of: from a file, not from the standard input");
  budget_seconds(options.budget);
  target_option(options.target);
  seed_of(options.seed);
  if (options.seed_is_given && (options.study.empty() || !find_study(options.study).takes_seed))
    throw UsageError("--seed", fmt::format("only of a study whose scenes are made by chance: --study {}",
                                           studies_with_seed()));
  if (options.study.empty()) {
    if (options.scene.volume.empty()) throw UsageError("VOLUME, or --study", "one of them is required");
    return;
  }
  const Study& study = find_study(options.study);
  if (!options.scene.volume.empty() && !study.takes_volume)
    throw UsageError("--study", fmt::format("{} has scenes of its own: without VOLUME", study.name));
  if (options.budget_is_given && !study.takes_budget)
    throw UsageError("--budget",
                     fmt::format("--study {} takes the time that it needs: without --budget", study.name));
  if (options.scene.volume.empty() && options.scene.has_any())
    throw UsageError(
        "--study",
        fmt::format("without VOLUME, {} has scenes of its own: no preset, mode or camera", study.name));
}

/// What the config file sets for reports is left out of one that has no use for it.
void settle_with_config(ReportOptions& options, const Options& command) {
  const Study* study = options.study.empty() ? nullptr : &find_study(options.study);
  if (!study || !study->takes_seed) command.leave_out({"--seed"});
  if (study && !study->takes_budget) command.leave_out({"--budget"});
  if (study && options.scene.volume.empty()) command.leave_out(SceneOptions::option_names());
  options.scene.leave_out_unused(command);
  options.size_is_given = command.is_given("--size");
  options.budget_is_given = command.is_given("--budget");
  options.seed_is_given = command.is_given("--seed");
}

std::string study_help() {
  std::string text = "A study instead of a scene's report:";
  for (const Study& study : studies()) text += fmt::format("\n{}: {}", study.name, study.summary);
  return text;
}

}  // namespace

void add_report_command(Options app, Command& chosen) {
  auto options = std::make_shared<ReportOptions>();
  Options command =
      app.add_command("report", "Measure error against run time, and write a report", "Measure");
  command.add("VOLUME", options->scene.volume, "What to render (crest --help)").offers(builtin_sources());
  options->scene.add_to(command);
  command.add("-o,--output", options->output, "The folder of the report")
      .required()
      .not_empty()
      .type_name("DIR");
  command.add("--size", options->size, "Width x height in pixels").shows_default().type_name("WxH");
  const Option study =
      command.add("--study", options->study, study_help()).type_name("NAME").offers(study_names());
  command
      .add("--budget", options->budget,
           "Time for all of it: 90s, 2m, 1h, or none; of a study that takes one, none by default")
      .shows_default()
      .type_name("TIME");
  command
      .add("--target-error", options->target,
           "The error that the recommended setting keeps under: share, rmse, max, p999, flip, missed "
           "or invented")
      .shows_default()
      .type_name("LIMIT")
      .excludes(study);
  command.add("--seed", options->seed, "Which random scenes: a number, for --study random")
      .shows_default()
      .type_name("N");
  command
      .add("--data", options->data_folder,
           "A folder of real volumes, for studies that use those of them that are there")
      .or_environment("CREST_DATA")
      .type_name("DIR");
  command.add("--device", options->device, "Graphics device (crest list devices); hardware first by default");
  command.add_flag("--json", options->json, "Print report.json, too");
  command.add_example("crest report builtin:plume --preset fire --budget 60s -o report");
  command.when_read([options, command, &chosen] {
    settle_with_config(*options, command);
    check_options(*options);
    options->command = command.text();
    chosen = [options] { run_report(*options); };
  });
}

}  // namespace crest
