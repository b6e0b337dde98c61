#include <utility>

#include "app/sources.h"
#include "app/studio.h"
#include "presets/preset_file.h"
#include "ui/examples.h"
#include "ui/studio_state.h"

// The small pictures of what can be opened.

namespace crest {
namespace {

/// What the last look at a volume, or with a preset, is found by.
std::string recent_key(const std::string& source) { return "recent " + absolute_source(source); }

std::string example_key(const Example& example) {
  return std::string("example ") + example.volume + " " + example.preset;
}

}  // namespace

void Studio::add_start_pictures(StudioInputs& inputs) {
  for (const std::string& source : inputs.recent)
    inputs.recent_pictures.push_back(thumbnails_.texture(recent_key(source)));
  for (const Example& example : examples())
    inputs.example_pictures.push_back(thumbnails_.texture(example_key(example)));
}

/// Of the view that the preset itself is about, where it shows what it is to show, or another that does.
void Studio::keep_thumbnails() {
  if (!loaded_.volume) return;
  const auto wanted = views_.wanted_versions(), shown = views_.shown_versions();
  std::uintptr_t texture = 0;
  for (int i = 0; i < view_count; ++i) {
    const std::size_t at = std::size_t(i);
    const ViewPicture view = views_.picture(i);
    if (view.texture == 0 || wanted[at] != shown[at] || view.coarseness > 1) continue;
    const ViewContent& content = ui_->views.contents[at];
    if (content.other) continue;
    if (texture == 0 || content.mode == document_.preset.rendering.mode) texture = view.texture;
  }
  if (texture == 0) return;
  const Thumbnail thumbnail = thumbnail_of_texture(GLuint(texture));
  const auto put = [&](const std::string& key) {
    thumbnails_.show(key, thumbnail);
    thumbnail_maker_.keep(key, thumbnail);
  };
  put(recent_key(loaded_.source));
  if (!document_.preset_path.empty()) put(recent_key(document_.preset_path.string()));
}

/// Before the panels are drawn, so that they show them.
void Studio::take_thumbnails() {
  for (const ThumbnailMaker::Made& made : thumbnail_maker_.take()) thumbnails_.show(made.key, made.thumbnail);
}

void Studio::want_thumbnails(const StudioRequests& requests) {
  std::vector<ThumbnailJob> jobs;
  if (requests.shows_start_page)
    for (const Example& example : examples())
      if (std::string key = example_key(example); thumbnails_.texture(key) == 0)
        jobs.push_back(
            {std::move(key), nullptr, example.volume, [name = example.preset] { return load_preset(name); }});
  if (requests.shows_library)
    for (ThumbnailJob& job : library_jobs()) jobs.push_back(std::move(job));
  thumbnail_maker_.want(std::move(jobs));
}

}  // namespace crest
