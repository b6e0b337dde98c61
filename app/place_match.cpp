#include "app/place_match.h"

#include <utility>

namespace crest {

PlaceMatch::PlaceMatch()
    : task_([](const Pair& pair, const std::stop_token&) {
        return std::optional(fit_values(*pair.from, *pair.to));
      }) {}

void PlaceMatch::start(const std::string& last, std::shared_ptr<const Volume> present) {
  cancel();
  present_ = std::move(present);
  loader_.start(last);
}

void PlaceMatch::cancel() {
  loader_.cancel();
  task_.stop();
  present_.reset();
}

std::optional<PlaceMatch::Outcome> PlaceMatch::take() {
  if (auto last = loader_.take()) {
    if (!last->volume) return Outcome{std::nullopt, last->error};
    task_.start({std::move(last->volume), std::exchange(present_, nullptr)});
  }
  auto outcome = task_.take();
  if (!outcome) return std::nullopt;
  return Outcome{std::move(outcome->result), std::move(outcome->error)};
}

}  // namespace crest
