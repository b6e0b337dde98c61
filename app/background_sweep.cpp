#include "app/background_sweep.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "app/cache_folder.h"
#include "app/offscreen_context.h"
#include "app/thread_priority.h"
#include "render/measure/measure_scene.h"
#include "render/measure/methods.h"
#include "render/measure/model_difference.h"

namespace crest {
namespace {

constexpr double longest_side = 256;
constexpr int side_unit = 8;  ///< so that a view that grows by some pixels is the same subject
constexpr double group_seconds = 1;

/// Of the exact answers that are there, one for each.
std::vector<AnswerError> model_differences(const Sweep& sweep, const Rendering& scene) {
  std::vector<AnswerError> differences;
  for (const auto& [answer, exact] : sweep.references())
    if (const auto difference = model_difference(sweep.references(), answer, scene))
      differences.push_back({answer, *difference});
  return differences;
}

}  // namespace

bool is_same_sweep(const SweepSubject& a, const SweepSubject& b) {
  // All that a method takes from the scene, but for the filters: a sweep has methods of each
  const auto taken = [](const Rendering& r) {
    return measured_rendering(methods().front(), 1, with_filters_of(r, {}));
  };
  const Rendering &ra = a.scene.rendering, &rb = b.scene.rendering;
  return a.scene.volume == b.scene.volume && a.scene.tf == b.scene.tf && a.camera == b.camera &&
         a.size == b.size && (ra == rb || taken(ra) == taken(rb));
}

glm::ivec2 sweep_size(glm::ivec2 view_pixels) {
  const double scale = std::min(1.0, longest_side / std::max(view_pixels.x, view_pixels.y));
  const auto side = [&](int pixels) {
    return side_unit * std::max(1, int(std::lround(pixels * scale / side_unit)));
  };
  return {side(view_pixels.x), side(view_pixels.y)};
}

SweepRenderer offscreen_sweep_renderer() {
  const auto context = std::make_shared<OffscreenContext>();
  return {context->renderer(), [context](const SweepSubject& subject) {
            return measure_scene(subject.scene, subject.camera, subject.size, cache_folder());
          }};
}

BackgroundSweep::BackgroundSweep(std::function<SweepRenderer()> make_renderer)
    : make_renderer_(std::move(make_renderer)) {}

BackgroundSweep::~BackgroundSweep() {
  stop();
  thread_.request_stop();
}

void BackgroundSweep::switch_on() {
  is_on_ = true;
  if (latest_) begin();
}

void BackgroundSweep::switch_off() {
  is_on_ = false;
  stop();
}

void BackgroundSweep::update(const SweepSubject& subject, Clock::time_point now) {
  if (!latest_ || !is_same_sweep(*latest_, subject)) changed_at_ = now;
  latest_ = subject;
  if (is_on_ && is_outdated() && now >= changed_at_ + pause) begin();
}

void BackgroundSweep::leave() {
  if (!latest_) return;
  stop();
  latest_.reset();
  begun_.reset();
}

void BackgroundSweep::rest_until(Clock::time_point time) {
  const std::scoped_lock lock(mutex_);
  rest_until_ = std::max(rest_until_, time);
}

bool BackgroundSweep::is_outdated() const { return latest_ && !(begun_ && is_same_sweep(*begun_, *latest_)); }

bool BackgroundSweep::is_active() const {
  if (!is_on_) return false;
  const std::scoped_lock lock(mutex_);
  return found_.is_running || is_outdated();
}

bool BackgroundSweep::has_news(Clock::time_point now) const {
  if (is_on_ && is_outdated() && now >= changed_at_ + pause) return true;
  const std::scoped_lock lock(mutex_);
  return version_ != seen_version_;
}

const AccuracyResults& BackgroundSweep::results() {
  {
    const std::scoped_lock lock(mutex_);
    if (std::exchange(seen_version_, version_) != version_) seen_ = found_;
    seen_.is_stale = found_.is_stale || is_outdated();
  }
  seen_.is_on = is_on_;
  return seen_;
}

void BackgroundSweep::begin() {
  stop();
  begun_ = latest_;
  {
    const std::scoped_lock lock(mutex_);
    next_ = *latest_;
    run_ = std::stop_source();
    found_.is_running = true;
    found_.is_stale = true;  // until the first point comes, the old ones are better than none
    found_.doing = "getting ready";
    found_.error.clear();
    ++version_;
  }
  if (!thread_.joinable()) thread_ = std::jthread([this](const std::stop_token& quit) { work(quit); });
  wake_.notify_all();
}

void BackgroundSweep::stop() {
  const std::scoped_lock lock(mutex_);
  run_.request_stop();
  next_.reset();
  found_.is_running = false;
  found_.doing.clear();
  ++version_;
}

void BackgroundSweep::publish(const std::stop_token& stopped,
                              const std::function<void(AccuracyResults&)>& change) {
  const std::scoped_lock lock(mutex_);
  if (stopped.stop_requested()) return;
  change(found_);
  ++version_;
}

void BackgroundSweep::work(const std::stop_token& quit) {
  lower_thread_priority();
  std::optional<SweepRenderer> renderer;
  while (true) {
    SweepSubject subject;
    std::stop_token stopped;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, quit, [&] { return next_.has_value(); })) return;
      subject = *std::exchange(next_, std::nullopt);
      stopped = run_.get_token();
    }
    try {
      if (!renderer) renderer = make_renderer_();
      run(*renderer, subject, stopped);
    } catch (const std::exception& error) {
      publish(stopped, [&](AccuracyResults& found) { found.error = error.what(); });
    }
    publish(stopped, [](AccuracyResults& found) {
      found.is_running = false;
      found.doing.clear();
    });
  }
}

void BackgroundSweep::run(const SweepRenderer& renderer, const SweepSubject& subject,
                          const std::stop_token& stopped) {
  SweepSettings settings;
  settings.group_seconds = group_seconds;
  settings.longest_frame_ms = longest_frame_ms;
  Sweep sweep(subject.scene, resting(renderer.measurer_of(subject), stopped), settings);
  bool is_first = true;
  std::size_t answers = 0;
  std::vector<AnswerError> differences;
  const auto compare_answers = [&] {
    if (std::exchange(answers, sweep.references().size()) != sweep.references().size())
      differences = model_differences(sweep, subject.scene.rendering);
  };
  const auto take = [&](AccuracyResults& found) {
    found.left_out = sweep.left_out();
    found.model_differences = differences;
    if (!std::exchange(is_first, false)) return;
    found.measured.clear();
    found.is_stale = false;
    found.rendering = subject.scene.rendering;
    found.size = subject.size;
    found.renderer = renderer.name;
  };
  const auto status = [&](std::string_view doing, double done) {
    publish(stopped, [&](AccuracyResults& found) {
      found.doing = doing;
      found.done = done;
    });
  };
  while (const auto point = sweep.next(stopped, status)) {
    compare_answers();
    publish(stopped, [&](AccuracyResults& found) {
      take(found);
      found.measured.push_back(point->measurement);
    });
  }
  compare_answers();
  publish(stopped, take);
}

Measurer BackgroundSweep::resting(Measurer measurer, const std::stop_token& stopped) {
  const auto after_rest = [this, stopped](auto work) {
    return [this, stopped, work = std::move(work)](const Rendering& rendering) {
      rest(stopped);
      return work(rendering);
    };
  };
  measurer.start = after_rest(std::move(measurer.start));
  measurer.picture = after_rest(std::move(measurer.picture));
  measurer.frame = after_rest(std::move(measurer.frame));
  measurer.reference = [this, stopped, render = std::move(measurer.reference)](const ExactAnswer& answer,
                                                                               const Progress& progress) {
    return render(answer, [&](double done) {
      rest(stopped);
      return progress(done);
    });
  };
  return measurer;
}

void BackgroundSweep::rest(const std::stop_token& stopped) {
  std::unique_lock lock(mutex_);
  while (!stopped.stop_requested() && Clock::now() < rest_until_) {
    const Clock::time_point end = rest_until_;
    wake_.wait_until(lock, stopped, end, [] { return false; });
  }
}

}  // namespace crest
