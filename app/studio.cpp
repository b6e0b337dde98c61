#include "app/studio.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/cache_folder.h"
#include "app/export_files.h"
#include "app/scene_options.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/exchange/exporters.h"
#include "presets/preset_file.h"
#include "render/files/file_request.h"
#include "render/files/load.h"
#include "render/scene/camera.h"
#include "render/scene/exact.h"
#include "render/scene/export_input.h"
#include "ui/studio_state.h"

namespace crest {
namespace {

/// So long after the person did something, the measurement begins no frame.
constexpr std::chrono::milliseconds quiet{300};

bool is_preset_file(const std::string& source) {
  return std::ranges::find(preset_extensions(), extension_of(source)) != preset_extensions().end();
}

/// What is in a file of another program; nothing where it is none.
std::vector<Imported> presets_of_another_program(const std::string& path) {
  constexpr std::size_t most = std::size_t(64) << 20;
  const std::string content = read_file(path, most);
  if (!find_importer(content, path) || is_own_preset(content)) return {};
  return import_presets(content, path);
}

Preset without_camera(Preset preset) {
  preset.camera.reset();
  return preset;
}

}  // namespace

Studio::Studio(Document document, FitPreset fit, std::filesystem::path shader_folder)
    : document_(std::move(document)),
      saved_(document_.preset),
      fit_(std::move(fit)),
      views_(std::move(shader_folder), program_folder()) {
  if (document_.volume_source.empty())
    say("Open a volume: Ctrl+O, the Volume menu, or drop a file on the window");
}

void Studio::say(std::string text, bool is_error) {
  message_ = std::move(text);
  message_is_error_ = is_error;
}

// The message goes when what it was about does.
void Studio::tell_view_error() {
  const std::string error = views_.error();
  if (error == view_error_) return;
  if (!error.empty())
    say(error, true);
  else if (message_ == view_error_)
    say("");
  view_error_ = error;
}

bool Studio::has_unsaved_changes() const {
  return without_camera(document_.preset) != without_camera(saved_);
}

std::string Studio::title() const {
  const std::string name =
      document_.preset_path.empty() ? "new preset" : document_.preset_path.filename().string();
  return fmt::format("{}{} - {} - Crest", has_unsaved_changes() ? "* " : "", name,
                     loaded_.volume ? loaded_.volume->name : "no volume");
}

void Studio::start_loading(const std::string& source) {
  loading_for_document_ = false;
  say("");
  loader_.start(source);
}

void Studio::cancel_loading() {
  if (!is_loading()) return;
  say(fmt::format("{} is not read", loader_.source()));
  loader_.cancel();
  document_.volume_source = loaded_.source;
}

void Studio::carry_over(CarryBy by) {
  if (!last_volume_ || !loaded_.volume) return;
  TransferFunction& tf = document_.preset.transfer_function;
  tf = last_volume_->carried_to(loaded_.volume->statistics.range, matters_.values(), by, tf.domain);
  ui_->editor.visible.reset();
  say(fmt::format("Carried over from {}", last_volume_->name));
}

void Studio::show(Loaded fresh) {
  if (!loading_for_document_ && loaded_.volume)
    last_volume_ = last_volume(*loaded_.volume, document_.preset.transfer_function, matters_.values());
  Preset preset = document_.preset;
  if (fit_) preset = fit_(std::move(preset), *fresh.volume, view_aspect_);
  views_.renderer().hold(fresh.volume);  // the driver must hold it, too
  const bool was_saved = !has_unsaved_changes();
  document_.preset = std::move(preset);
  if (was_saved) saved_ = document_.preset;
  fit_ = nullptr;
  loaded_ = std::move(fresh);
  matters_.set_volume(loaded_.volume);
  if (!loading_for_document_) document_.volume_source = loaded_.source;
  recent_.add(loaded_.source);
  const Volume& volume = *loaded_.volume;
  const glm::ivec3 dims = volume.grid.dims;
  say(fmt::format("{}: {}x{}x{} {}{}{}{}", volume.name, dims.x, dims.y, dims.z, name_of(volume.file_type),
                  volume.note.empty() ? "" : ", ", volume.note,
                  last_volume_ ? "; Preset, Carry over fits the curve to it" : ""));
}

void Studio::take_loaded_volume() {
  auto result = loader_.take();
  if (!result) return;
  try {
    if (!result->volume) throw Error(result->error);
    show({result->source, std::move(result->volume)});
  } catch (const std::exception& error) {
    // What was there stays
    if (document_.volume_source == result->source) document_.volume_source = loaded_.source;
    say(error.what(), true);
  }
}

void Studio::open_preset(const std::string& name_or_path, TfParts take) {
  try {
    const bool is_file = std::filesystem::exists(name_or_path);
    if (is_file) imported_ = presets_of_another_program(name_or_path);
    if (!imported_.empty()) {
      imported_from_ = name_or_path;
      import_take_ = take;
      return;
    }
    Preset preset = load_preset(name_or_path);
    fit_ = nullptr;  // was for the preset of the command line
    if (TransferFunction& tf = document_.preset.transfer_function; take != TfParts::both) {
      tf = combined(tf, preset.transfer_function, take, false);
      say(fmt::format("Took {} from {}", take == TfParts::colors ? "the colours" : "the opacities",
                      name_or_path));
      return;
    }
    document_.preset = std::move(preset);
    document_.preset_path = is_file ? std::filesystem::path(name_or_path) : std::filesystem::path();
    saved_ = document_.preset;
    if (is_file) recent_.add(name_or_path);
    say(fmt::format("Opened {}", name_or_path));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::take_import(const StudioRequests::Import& choice) {
  const std::vector<Imported> all = std::exchange(imported_, {});
  if (choice.index < 0 || choice.index >= int(all.size())) return;
  const Imported& one = all[std::size_t(choice.index)];
  TransferFunction read = one.preset.transfer_function;
  if (loaded_.volume) {
    const Grid& grid = loaded_.volume->grid;
    read = for_volume(one, glm::dvec3(grid.dims) * grid.spacing);
  }
  // How the preset is rendered, and from where, stays; but for a light that the file asks for
  Preset& preset = document_.preset;
  preset.transfer_function = combined(preset.transfer_function, read, choice.take, choice.fit);
  if (choice.take == TfParts::both) {
    preset.name = one.preset.name;
    if (one.preset.rendering.shading != Shading::none)
      preset.rendering.shading = one.preset.rendering.shading;
    document_.preset_path.clear();
    fit_ = nullptr;
  }
  say(fmt::format("Imported {} from {}", one.preset.name, imported_from_));
}

void Studio::export_to(const StudioRequests::Export& request) {
  try {
    const Exporter& exporter = exporters()[std::size_t(request.what.format)];
    const ExportInput input = export_input(document_.preset, loaded_.volume.get(), request.what.rows,
                                           stem_of(request.path, exporter.extension));
    const Exported exported = exporter.write(input);
    write_export(exported, input.stem, request.path);
    std::string more;
    for (std::size_t i = 1; i < exported.files.size(); ++i)
      more += fmt::format("{}{}", i == 1 ? " and *" : ", *", exported.files[i].suffix);
    say(fmt::format("Exported {}{}", request.path.string(), more));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::update_export_picture(const StudioRequests& requests) {
  if (!requests.preview_export || !loaded_.volume) return export_picture_.clear();
  try {
    export_picture_.update(views_.renderer(), loaded_.volume, document_.preset, *requests.preview_export);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::update_slices(const StudioRequests& requests) {
  if (!requests.slices || !loaded_.volume) return;
  try {
    slices_.update(views_.renderer().resources(), make_scene(loaded_.volume, document_.preset),
                   *requests.slices);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::save_preset_to(const std::filesystem::path& path) {
  try {
    save_preset(path, document_.preset);
    document_.preset_path = path;
    saved_ = document_.preset;
    recent_.add(path.string());
    say(fmt::format("Saved {}", path.string()));
  } catch (const std::exception& error) {
    quit_ = false;  // a person who saves before quitting must not lose what could not be saved
    say(error.what(), true);
  }
}

void Studio::open(const std::string& source) {
  if (is_preset_file(source))
    open_preset(source, TfParts::both);
  else
    start_loading(source);
}

void Studio::handle(const StudioRequests& requests) {
  quit_ = requests.quit;
  if (requests.new_preset) {
    fit_ = nullptr;
    document_.preset = Preset{};
    document_.preset.transfer_function = default_transfer_function();
    document_.preset_path.clear();
    saved_ = document_.preset;
  }
  if (requests.open_preset) open_preset(*requests.open_preset, requests.take);
  if (requests.import_choice) take_import(*requests.import_choice);
  if (requests.export_preset) export_to(*requests.export_preset);
  if (requests.carry) carry_over(*requests.carry);
  if (requests.save_preset) save_preset_to(*requests.save_preset);
  if (requests.cancel_loading) cancel_loading();
  if (requests.open_volume) start_loading(*requests.open_volume);
  if (requests.reload_shaders) {
    views_.renderer().resources().programs.reload();
    views_.invalidate();
  }
  if (requests.measure) *requests.measure ? sweep_.switch_on() : sweep_.switch_off();
}

StudioInputs Studio::inputs(bool close_requested) {
  StudioInputs inputs;
  inputs.unsaved_changes = has_unsaved_changes();
  inputs.close_requested = close_requested;
  if (is_loading()) inputs.loading = loader_.source();
  inputs.imported = imported_;
  inputs.import_take = import_take_;
  inputs.export_picture = export_picture_.picture();
  inputs.message = message_;
  inputs.message_is_error = message_is_error_;
  inputs.recent = recent_.list();
  inputs.performance = performance_;
  inputs.accuracy = &sweep_.results();
  inputs.choice = &choice_.results();
  for (int i = 0; i < view_count; ++i) inputs.views[std::size_t(i)] = views_.picture(i);
  if (!loaded_.volume) return inputs;
  const Scene scene = make_scene(loaded_.volume, document_.preset);
  const Classification& classification = views_.renderer().classification(scene);
  inputs.volume = loaded_.volume.get();
  inputs.resolved = scene.tf;
  inputs.peaks = classification.peaks;
  inputs.surfaces = classification.surfaces;
  inputs.slices = slices_.textures();
  if (const VolumeValues* values = matters_.values()) {
    inputs.by_value = &values->by_value;
    inputs.suggested = values->suggested;
  }
  if (last_volume_)
    inputs.carry_over = CarryOver{last_volume_->name, last_volume_->distribution && matters_.values()};
  inputs.visibility = matters_.visibility();
  inputs.visibility_is_old = matters_.is_visibility_old();
  inputs.why_no_values = matters_.why_no_values();
  inputs.why_no_visibility = matters_.why_no_visibility();
  return inputs;
}

std::array<ViewRequest, view_count> Studio::view_requests(const StudioRequests& requests) const {
  std::array<ViewRequest, view_count> wanted;
  if (!loaded_.volume) return wanted;
  const Scene scene = make_scene(loaded_.volume, document_.preset);
  for (std::size_t i = 0; i < view_count; ++i) {
    const glm::ivec2 size = requests.view_pixels[i];
    if (size.x <= 0) continue;
    wanted[i] = {scene, camera_of(document_.preset, loaded_.volume->grid, aspect_of(size)), size};
    Rendering& rendering = wanted[i].scene.rendering;
    rendering = in_mode(scene.rendering, view_modes[i]);
    if (requests.shown_picture == ShownPicture::as_set || !why_not_exact(rendering).empty()) continue;
    rendering = exact_rendering(rendering);
    wanted[i].error_bound = requests.shown_picture == ShownPicture::error_bound;
  }
  return wanted;
}

void Studio::update_sweep(const StudioRequests& requests, bool interactive) {
  const auto now = BackgroundSweep::Clock::now();
  if (interactive || is_drawing() || is_loading()) sweep_.rest_until(now + quiet);
  const auto view = std::ranges::find_if(requests.view_pixels, [](glm::ivec2 size) { return size.x > 0; });
  if (!loaded_.volume || view == requests.view_pixels.end()) return;
  sweep_.update({make_scene(loaded_.volume, document_.preset),
                 camera_of(document_.preset, loaded_.volume->grid, aspect_of(*view)), sweep_size(*view)},
                now);
}

SweepSubject Studio::choice_subject(glm::ivec2 size) const {
  return {make_scene(loaded_.volume, document_.preset),
          camera_of(document_.preset, loaded_.volume->grid, view_aspect_), size};
}

/// Before the panels are drawn, so that they show it.
void Studio::take_choice() {
  if (!loaded_.volume || !choice_.has_news()) return;
  if (const auto chosen = choice_.take(choice_subject({1, 1}))) document_.preset.rendering = *chosen;
}

/// The size of the view of the preset's own mode, or of another where that is not to be seen.
glm::ivec2 Studio::own_view(const StudioRequests& requests) const {
  glm::ivec2 size{0};
  for (std::size_t i = 0; i < view_count; ++i)
    if (const glm::ivec2 view = requests.view_pixels[i];
        view.x > 0 && (size.x == 0 || view_modes[i] == document_.preset.rendering.mode))
      size = view;
  return size;
}

void Studio::update_choice(const StudioRequests& requests) {
  if (requests.stop_choosing) choice_.stop();
  if (choice_.is_running() && loaded_.volume) choice_.update(choice_subject({1, 1}));
  if (choice_.is_running()) sweep_.rest_until(BackgroundSweep::Clock::now() + quiet);
  const glm::ivec2 size = own_view(requests);
  if (requests.choose && loaded_.volume && size.x > 0)
    choice_.start(choice_subject(size), {.target = *requests.choose});
}

void Studio::update_matters(const StudioRequests& requests, bool interactive) {
  std::optional<VisibilitySubject> picture;
  const glm::ivec2 size = own_view(requests);
  if (requests.show_visibility && loaded_.volume && size.x > 0)
    picture = {make_scene(loaded_.volume, document_.preset),
               camera_of(document_.preset, loaded_.volume->grid, aspect_of(size)), visibility_size(size)};
  matters_.update(std::move(picture), !interactive && !is_drawing() && !is_loading(),
                  WhatMatters::Clock::now());
}

void Studio::frame(bool close_requested, double render_ms, bool interactive) {
  take_loaded_volume();
  take_choice();
  matters_.take();
  StudioInputs shown;
  try {
    shown = inputs(close_requested);
  } catch (const std::exception& error) {
    say(error.what(), true);
    shown.message = message_;
    shown.message_is_error = true;
    shown.unsaved_changes = has_unsaved_changes();
    shown.close_requested = close_requested;
  }
  const StudioRequests requests = studio_frame(document_, *ui_, shown);
  handle(requests);
  for (const glm::ivec2 size : requests.view_pixels)
    if (size.x > 0) view_aspect_ = aspect_of(size);
  // At the start nothing is loaded, and undo can bring back another volume, also while one is read
  const bool reads_what_is_wanted =
      is_loading() && (!loading_for_document_ || loader_.source() == document_.volume_source);
  if (!reads_what_is_wanted && document_.volume_source != loaded_.source &&
      !document_.volume_source.empty()) {
    start_loading(document_.volume_source);
    loading_for_document_ = true;
  }
  views_.work(view_requests(requests), render_ms, interactive);
  tell_view_error();
  update_export_picture(requests);
  update_slices(requests);
  update_sweep(requests, interactive);
  update_choice(requests);
  update_matters(requests, interactive);
  if (const std::string& error = views_.renderer().resources().programs.error(); !error.empty())
    say(error, true);
}

}  // namespace crest
