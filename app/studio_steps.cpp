#include <utility>

#include "app/studio.h"
#include "render/files/time_steps.h"
#include "ui/studio_state.h"

// The time steps of the open volume: the studio shows what TimeSteps brings. The document names what was
// opened, not the step, so that going through steps is no edit.

namespace crest {

void Studio::take_time_step() {
  auto news = steps_.update(TimeSteps::Clock::now());
  if (!news) return;
  if (!news->error.empty()) return say(news->error, true);
  try {
    show_step(std::move(news->volume));
  } catch (const std::exception& error) {
    say(error.what(), true);
    steps_.open(loaded_.source, loaded_.volume);
  }
}

/// All stays but what was made of the values.
void Studio::show_step(std::shared_ptr<const Volume> volume) {
  views_.renderer().hold(volume);  // the driver must hold it, too
  place_match_.cancel();
  rays_.forget();
  slices_.forget();
  picked_.reset();
  loaded_.volume = std::move(volume);
  matters_.set_volume(loaded_.volume);
}

void Studio::update_time_steps(const StudioRequests& requests) {
  if (requests.play_steps) steps_.play(*requests.play_steps);
  if (!requests.go_to_step) return;
  steps_.play(false);
  steps_.go_to(*requests.go_to_step);
}

/// With the time step that is shown.
std::string Studio::shown_source() const {
  return steps_.count() > 1 ? source_of_step(loaded_.source, steps_.shown()) : loaded_.source;
}

std::optional<ShownSteps> Studio::shown_steps() const {
  if (steps_.count() < 2) return std::nullopt;
  return ShownSteps{steps_.count(), steps_.shown(), steps_.wanted(), steps_.known_ranges(),
                    steps_.is_playing()};
}

}  // namespace crest
