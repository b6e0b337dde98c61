#include <algorithm>
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
  const gl::DisplayTexture* kept = nullptr;
  for (int i = 0; i < view_count; ++i) {
    if (!views_.shows_what_is_wanted(i)) continue;
    const gl::DisplayTexture* display = views_.display(i);
    const ViewContent& content = ui_->views.contents[std::size_t(i)];
    if (content.other) continue;
    if (!kept || content.mode == document_.preset.rendering.mode) kept = display;
  }
  if (!kept) return;
  try {
    LeftPicture left{{recent_key(loaded_.source)}, gl::PendingRead(*kept)};
    if (!document_.preset_path.empty()) left.keys.push_back(recent_key(document_.preset_path.string()));
    left_pictures_.push_back(std::move(left));
  } catch (const std::exception&) {
    // No room: the picture of an earlier look stays
  }
}

/// One that the device fails to tell is dropped: the picture of an earlier look stays.
void Studio::take_left_picture(const LeftPicture& left, bool shows) try {
  const Thumbnail thumbnail = shrunk(left.picture.shown(), left.picture.size());
  for (const std::string& key : left.keys) {
    if (shows) thumbnails_.show(key, thumbnail);
    thumbnail_maker_.keep(key, thumbnail);
  }
} catch (const std::exception&) {
}

/// Those that the device is through with.
void Studio::take_left_pictures() {
  std::erase_if(left_pictures_, [&](const LeftPicture& left) {
    const bool is_over = left.picture.is_over();
    if (is_over) take_left_picture(left, true);
    return is_over;
  });
}

bool Studio::has_left_picture() const {
  return std::ranges::any_of(left_pictures_, [](const LeftPicture& left) { return left.picture.is_over(); });
}

/// Before the panels are drawn, so that they show them.
void Studio::take_thumbnails() {
  thumbnails_.begin_frame();
  take_left_pictures();
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
