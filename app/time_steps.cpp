#include "app/time_steps.h"

#include <algorithm>
#include <utility>

#include "render/files/time_steps.h"

namespace crest {

TimeSteps::TimeSteps() : TimeSteps(VolumeLoader::default_read()) {}

TimeSteps::TimeSteps(VolumeLoader::Read read)
    : loader_(std::move(read)), widening_([](const Widening& asked, const std::stop_token&) {
        auto wide = std::make_shared<Volume>(*asked.volume);  // which shares its values
        widen_range(*wide, asked.range);
        return std::optional<SharedVolume>(std::move(wide));
      }) {}

void TimeSteps::open(const std::string& source, SharedVolume volume) {
  loader_.cancel();
  widening_.stop();
  source_ = source;
  shown_ = std::move(volume);
  ahead_.reset();
  range_.reset();
  reading_ = -1;
  direction_ = 1;
  is_playing_ = gave_up_widening_ = false;
  steps_.assign(shown_ ? std::size_t(shown_->frames) : 0, {});
  wanted_ = shown();
  if (shown_) learn(shown_);
}

int TimeSteps::known_ranges() const { return int(std::ranges::count(steps_, true, &Step::is_known)); }

void TimeSteps::go_to(int step) {
  if (count() == 0) return;
  step = std::clamp(step, 0, count() - 1);
  if (step != wanted_) direction_ = step < wanted_ ? -1 : 1;
  wanted_ = step;
}

void TimeSteps::play(bool forward) {
  is_playing_ = forward && count() > 1;
  if (is_playing_) direction_ = 1;
}

int TimeSteps::next() const {
  const int step = shown() + direction_;
  if (step >= 0 && step < count()) return step;
  return is_playing_ ? 0 : -1;
}

bool TimeSteps::is_wide(const SharedVolume& volume) const {
  if (!range_ || gave_up_widening_) return true;
  const ValueRange has = volume->statistics.range;
  return has.min <= range_->min && has.max >= range_->max;
}

void TimeSteps::learn(const SharedVolume& volume) {
  Step& step = steps_[std::size_t(volume->frame)];
  if (std::exchange(step.is_known, true)) return;
  step.is_looked_at = true;
  step.range = finite_range(*volume);
  if (step.range) range_ = range_ ? joined(*range_, *step.range) : *step.range;
}

/// A list may grow while it is looked at: the program that writes it still runs.
void TimeSteps::fit_count(int frames) {
  steps_.resize(std::size_t(std::max(frames, shown() + 1)));
  wanted_ = std::min(wanted_, count() - 1);
}

std::optional<TimeSteps::News> TimeSteps::take_read() {
  const auto result = loader_.take();
  if (!result) return std::nullopt;
  const int step = std::exchange(reading_, -1);
  if (result->volume && result->volume->frame == step) {
    fit_count(result->volume->frames);
    if (step >= count()) return std::nullopt;
    learn(result->volume);
    if (step == wanted_ ? step != shown() : step == next()) ahead_ = result->volume;
    return std::nullopt;
  }
  steps_[std::size_t(step)].is_looked_at = true;
  if (step != wanted_) return std::nullopt;
  wanted_ = shown();
  is_playing_ = false;
  return News{nullptr, result->volume ? result->source + ": is not the step that it was" : result->error};
}

std::optional<TimeSteps::News> TimeSteps::take_widened() {
  auto outcome = widening_.take();
  if (!outcome) return std::nullopt;
  if (!outcome->result) {
    gave_up_widening_ = true;
    return std::nullopt;
  }
  SharedVolume& wide = *outcome->result;
  if (ahead_ && ahead_->frame == wide->frame) {
    ahead_ = std::move(wide);
  } else if (shown() == wide->frame) {
    shown_ = std::move(wide);
    return News{shown_, ""};
  }
  return std::nullopt;
}

std::optional<TimeSteps::News> TimeSteps::show_wanted(Clock::time_point now) {
  if (is_playing_ && wanted_ == shown() && now - shown_at_ >= pause) wanted_ = std::max(next(), 0);
  if (wanted_ == shown() || !ahead_ || ahead_->frame != wanted_) return std::nullopt;
  if (!is_wide(ahead_)) {
    if (!widening_.is_running()) widening_.start({ahead_, *range_});
    return std::nullopt;
  }
  shown_ = std::move(ahead_);
  ahead_.reset();
  shown_at_ = now;
  return News{shown_, ""};
}

void TimeSteps::read(int step) {
  loader_.cancel();
  reading_ = step;
  loader_.start(source_of_step(source_, step));
}

void TimeSteps::read_what_is_needed() {
  if (wanted_ != shown()) {
    if ((ahead_ && ahead_->frame == wanted_) || reading_ == wanted_) return;
    ahead_.reset();  // no more than one is held beside the shown one
    return read(wanted_);
  }
  if (reading_ >= 0 || widening_.is_running()) return;
  const int following = next();
  const bool is_held = ahead_ && ahead_->frame == following;
  const auto was_tried = [&](int step) {
    return steps_[std::size_t(step)].is_looked_at && !steps_[std::size_t(step)].is_known;
  };
  if (following >= 0 && following != shown() && !is_held && !was_tried(following)) {
    ahead_.reset();
    return read(following);
  }
  const auto unknown = std::ranges::find(steps_, false, &Step::is_looked_at);
  if (unknown != steps_.end()) return read(int(unknown - steps_.begin()));
  // All that can be known is: the shown step and the next one follow in that range
  if (!is_wide(shown_))
    widening_.start({shown_, *range_});
  else if (ahead_ && !is_wide(ahead_))
    widening_.start({ahead_, *range_});
}

std::optional<TimeSteps::News> TimeSteps::update(Clock::time_point now) {
  if (count() < 2) return std::nullopt;
  std::optional<News> news = take_read();
  if (!news) news = take_widened();
  if (!news) news = show_wanted(now);
  read_what_is_needed();
  return news;
}

bool TimeSteps::has_news(Clock::time_point now) const {
  if (loader_.has_news() || widening_.has_news()) return true;
  const bool waits_for_time = is_playing_ && wanted_ == shown();
  return waits_for_time ? now - shown_at_ >= pause : false;
}

}  // namespace crest
