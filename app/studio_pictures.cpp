#include <fmt/core.h>

#include <utility>

#include "app/editor_image.h"
#include "app/studio.h"
#include "presets/atomic_file.h"
#include "presets/error.h"
#include "presets/preset_file.h"
#include "render/files/image.h"
#include "ui/shown_values.h"
#include "ui/studio_state.h"

// What the studio saves of what it shows: pictures, a ray's table.

namespace crest {

void Studio::save_ray_to(const std::filesystem::path& path) {
  try {
    if (!rays_.inspection()) throw Error("no ray is inspected");
    write_file_atomically(path, ray_table(*rays_.inspection()));
    say(fmt::format("Saved {}", path.string()));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

/// At once: it is some triangles.
void Studio::save_editor_picture(const PictureAsk& ask) {
  try {
    Document shown = document_;
    TransferFunction& tf = shown.preset.transfer_function;
    if (const auto& volume = loaded_.volume)
      tf = shown_values(tf, shown_domain(tf, ui_->settings, true), volume->statistics.range);
    const Image image = editor_image(shown, ui_->editor, inputs(false), ask.size, ui_->settings.theme);
    write_image(ask.path, image, {}, write_preset(document_.preset));
    say(fmt::format("Saved {}", ask.path.string()));
  } catch (const std::exception& error) {
    say(error.what(), true);
  }
}

/// In the background, at a size of its own: the window stays live.
void Studio::save_picture(const PictureAsk& ask) {
  if (ask.view == picture_of_editor) return save_editor_picture(ask);
  if (!loaded_.volume) return;
  if (picture_maker_.is_busy()) return say("A picture is being saved: wait until it is done", true);
  const ViewsState& views = ui_->views;
  PictureJob job;
  job.size = ask.size;
  job.camera = camera_of(document_.preset, loaded_.volume->grid, aspect_of(ask.size));
  job.pictures = ask.turntable;
  job.path = ask.path;
  job.preset =
      ask.view < 0 ? document_.preset : preset_of(views.contents[std::size_t(ask.view)], document_.preset);
  const Scene own = make_scene(loaded_.volume, document_.preset);
  for (int i = 0; i < view_count; ++i) {
    if (ask.view != i && (ask.view >= 0 || i >= views.count)) continue;
    const ViewContent& content = views.contents[std::size_t(i)];
    const ViewRequest request = view_request(content, own, shown_by_all(views), ask.size);
    if (request.error_bound)
      return say("How far pixels may be off is saved by crest render --exact --error-bound FILE", true);
    job.views.push_back({request.scene, text_of(content)});
  }
  // The file dialog asked about the name that was typed, not about those that are made of it
  for (int i = 0; i < job.pictures && job.pictures > 1; ++i)
    if (const auto path = numbered(job.path, i, job.pictures); std::filesystem::exists(path))
      return say(fmt::format("{} is there already: choose another name", path.string()), true);
  picture_maker_.start(std::move(job));
  say(fmt::format("Saving {} ...", ask.path.string()));
}

void Studio::take_saved_picture() {
  const auto outcome = picture_maker_.take();
  if (!outcome) return;
  if (!outcome->error.empty())
    say(outcome->error, true);
  else if (outcome->result)
    say(*outcome->result);
}

}  // namespace crest
