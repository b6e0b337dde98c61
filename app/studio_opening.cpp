#include <fmt/core.h>

#include "app/studio.h"
#include "render/files/time_steps.h"

// What the studio asks before it can open a volume.

namespace crest {

void Studio::ask_what_to_open(const OpenChoice& choice) {
  opening_ = Opening{choice, 0, {}};
  if (choice.kind != ChoiceKind::raw_layout) return;
  std::error_code gone;
  const std::uintmax_t bytes = std::filesystem::file_size(first_file(choice.path), gone);
  if (!gone) opening_->file_bytes = bytes;
}

void Studio::stop_asking() {
  opening_.reset();
  raw_preview_.forget();
}

/// Before the panels are drawn, so that they show it.
void Studio::take_raw_preview() {
  raw_preview_.take();
  if (opening_) opening_->picture = raw_preview_.picture();
}

void Studio::update_opening(const StudioRequests& requests) {
  if (!opening_) return;
  if (requests.cancel_opening) {
    say(fmt::format("{} is not opened", opening_->choice.path));
    stop_asking();
  } else if (requests.preview_raw) {
    raw_preview_.want(first_file(opening_->choice.path), *requests.preview_raw);
  }
}

}  // namespace crest
