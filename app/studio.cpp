#include "app/studio.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/cache_folder.h"
#include "app/manual.h"
#include "app/user_folders.h"
#include "render/scene/camera.h"
#include "render/scene/exact.h"
#include "ui/studio_state.h"

namespace crest {
namespace {

/// So long after the person did something, the measurement begins no frame.
constexpr std::chrono::milliseconds quiet{300};

}  // namespace

Studio::Studio(Document document, FitPreset fit, std::filesystem::path shader_folder)
    : document_(std::move(document)),
      fit_(std::move(fit)),
      views_(std::move(shader_folder), program_folder()),
      thumbnails_(thumbnail_folder()),
      thumbnail_maker_(
          [this](const std::string& key, const Thumbnail& thumbnail) { thumbnails_.write(key, thumbnail); }),
      own_presets_(own_preset_folder()),
      autosave_(recovery_folder()) {
  mark_saved();
  find_recoveries();
}

void Studio::say(std::string text, bool is_error) {
  message_ = std::move(text);
  message_is_error_ = is_error;
}

void Studio::use_settings(const ReadSettings& read) {
  ui_->settings = kept_settings_ = read.settings;
  if (!read.problem.empty()) say(read.problem, true);
}

const StudioSettings& Studio::settings() const { return ui_->settings; }

void Studio::keep_settings() {
  if (const std::string error = settings_writer_.take_error(); !error.empty())
    say(fmt::format("The settings are not kept: {}", error), true);
  if (ui_->settings == kept_settings_) return;
  kept_settings_ = ui_->settings;
  const std::filesystem::path file = settings_file();
  if (file.empty()) return;
  settings_writer_.start([file, settings = kept_settings_] { write_settings(file, settings); });
}

void Studio::finish_writing() {
  recent_.finish_writing();
  settings_writer_.finish();
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

std::string Studio::title() const {
  return fmt::format("{}{} - {} - Crest", has_unsaved_changes() ? "* " : "", preset_label(document_),
                     loaded_.volume ? loaded_.volume->name : "no volume");
}

void Studio::update_export_picture(const StudioRequests& requests) {
  if (!requests.preview_export || !loaded_.volume) return export_picture_.clear();
  try {
    export_picture_.update(views_.renderer(), loaded_.volume, document_.preset, *requests.preview_export);
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

void Studio::handle(const StudioRequests& requests) {
  // A person who saves before something else must not lose what could not be saved
  const bool goes_on = !requests.save_preset || save_preset_to(*requests.save_preset);
  quit_ = requests.quit && goes_on;
  if (requests.close_message) say("");
  if (!requests.problem.empty()) say(requests.problem, true);
  if (requests.new_preset && goes_on) {
    fit_ = nullptr;
    document_.preset = new_preset();
    document_.preset_path.clear();
    document_.library_name.clear();
    mark_saved();
  }
  if (requests.open_preset && goes_on) open_preset(*requests.open_preset, requests.take);
  if (requests.import_choice) take_import(*requests.import_choice);
  if (requests.export_preset) export_to(*requests.export_preset);
  if (requests.carry) carry_over(*requests.carry);
  if (requests.save_ray) save_ray_to(*requests.save_ray);
  if (requests.save_picture) save_picture(*requests.save_picture);
  if (requests.cancel_loading) cancel_loading();
  if (requests.open_volume) start_loading(*requests.open_volume);
  if (requests.reload_shaders) {
    views_.renderer().resources().programs.reload();
    shader_error_.clear();  // the same one is news again
    views_.invalidate();
  }
  if (requests.recovery) take_recovery(*requests.recovery);
  if (requests.measure) *requests.measure ? sweep_.switch_on() : sweep_.switch_off();
  if (requests.close_volume) close_volume();
  if (requests.open_manual) {
    const ManualOpened opened = open_manual(*requests.open_manual);
    say(opened.message, opened.is_error);
  }
  if (requests.reads_library) own_presets_.read_again(), read_library();
  if (requests.library) change_library(*requests.library);
  if (!quit_) return;
  keep_thumbnails();
  // For the next start: the last frame, which is not drawn yet, shows what it shows
  for (const LeftPicture& left : std::exchange(left_pictures_, {})) take_left_picture(left, false);
  autosave_.end();  // saved, or discarded by choice
}

StudioInputs Studio::inputs(bool close_requested) {
  StudioInputs inputs;
  inputs.unsaved_changes = has_unsaved_changes();
  inputs.saved = saved_preset();
  inputs.close_requested = close_requested;
  if (is_loading()) {
    inputs.loading = loader_.source();
    inputs.loading_share = loader_.share();
  }
  inputs.imported = imported_;
  inputs.import_take = import_take_;
  inputs.export_picture = export_picture_.picture();
  inputs.version = CREST_VERSION;
  inputs.message = message_;
  inputs.message_is_error = message_is_error_;
  inputs.recent = recent_.list();
  inputs.performance = performance_;
  inputs.saving = picture_maker_.progress();
  inputs.library = library_;
  inputs.opening = opening_ ? &*opening_ : nullptr;
  inputs.recovery = recovery_offer();
  inputs.accuracy = &sweep_.results();
  inputs.choice = &choice_.results();
  if (!loaded_.volume) add_start_pictures(inputs);
  for (int i = 0; i < picture_count; ++i) inputs.views[std::size_t(i)] = views_.picture(i);
  inputs.difference = difference_.picture();
  inputs.ray = rays_.inspection();
  inputs.picked = picked_;
  if (!loaded_.volume) return inputs;
  const Scene scene = make_scene(loaded_.volume, document_.preset);
  const Classification& classification = views_.renderer().classification(scene);
  inputs.volume = loaded_.volume.get();
  inputs.resolved = scene.tf;
  inputs.peaks = classification.peaks;
  inputs.surfaces = classification.surfaces;
  inputs.slices = slices_.textures();
  inputs.steps = shown_steps();
  if (const VolumeValues* values = matters_.values()) {
    inputs.by_value = &values->by_value;
    inputs.suggested = values->suggested;
  }
  if (last_volume_)
    inputs.carry_over = CarryOver{last_volume_->name, last_volume_->distribution && matters_.values(),
                                  last_volume_->dims == loaded_.volume->grid.dims};
  inputs.visibility = matters_.visibility();
  inputs.visibility_is_old = matters_.is_visibility_old();
  inputs.why_no_values = matters_.why_no_values();
  inputs.why_no_visibility = matters_.why_no_visibility();
  return inputs;
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
  if (!choice_.has_news()) return;
  const SweepSubject now = loaded_.volume ? choice_subject({1, 1}) : SweepSubject();
  if (const auto chosen = choice_.take(now)) document_.preset.rendering = *chosen;
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
  take_time_step();
  take_choice();
  matters_.take();
  take_thumbnails();
  take_saved_picture();
  take_raw_preview();
  take_place_match();
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
  shown.dropped_preset = std::exchange(dropped_preset_, std::nullopt);
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
  // Undone until before a volume was open
  if (document_.volume_source.empty() && loaded_.volume && !is_loading()) close_volume();
  views_.keep_colors(requests.comparison && requests.comparison->takes_difference());
  views_.work(view_requests(requests), render_ms, interactive);
  update_difference(requests, interactive);
  animates_ = requests.animates;
  tell_view_error();
  update_export_picture(requests);
  update_rays(requests, interactive);
  update_slices(requests);
  update_sweep(requests, interactive);
  update_choice(requests);
  update_matters(requests, interactive);
  want_thumbnails(requests);
  update_opening(requests);
  update_time_steps(requests);
  if (const std::string& error = views_.renderer().resources().programs.error(); error != shader_error_) {
    shader_error_ = error;
    if (!error.empty()) say(error, true);
  }
  keep_settings();
}

}  // namespace crest
