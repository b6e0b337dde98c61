#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "render/measure/sweep.h"
#include "ui/accuracy_results.h"

namespace crest {

/// What is measured: a scene as a camera sees it, in pictures of a size.
struct SweepSubject {
  Scene scene;
  Camera camera;
  glm::ivec2 size{0};
};

/// Whether a sweep of either finds the same: they differ at most in what the sweep varies (mode, form, step,
/// placement) or leaves out (shading, early termination).
bool is_same_sweep(const SweepSubject& a, const SweepSubject& b);

/// The size in which a view is measured: of about its shape, with at most 256 pixels a side.
glm::ivec2 sweep_size(glm::ivec2 view_pixels);

/// What measures. It is made, called, and dies in the thread of the sweep.
struct SweepRenderer {
  std::string name;
  std::function<Measurer(const SweepSubject&)> measurer_of;
};
/// The ray caster, in an off-screen context of its own. Throws Error.
SweepRenderer offscreen_sweep_renderer();

/// A sweep in a thread of its own, beside the window. Nothing is made before it is switched on, no call waits
/// for it, and it rests while the person does something.
class BackgroundSweep {
 public:
  using Clock = std::chrono::steady_clock;
  /// So long after the last change that matters to it, the sweep begins again.
  static constexpr std::chrono::milliseconds pause{500};
  /// What takes longer is not measured: a frame cannot be stopped, nor give way to the window.
  static constexpr double longest_frame_ms = 400;

  explicit BackgroundSweep(std::function<SweepRenderer()> make_renderer = offscreen_sweep_renderer);
  ~BackgroundSweep();  ///< waits for the frame that is being drawn
  BackgroundSweep(const BackgroundSweep&) = delete;
  BackgroundSweep& operator=(const BackgroundSweep&) = delete;

  void switch_on();   ///< measures what update() told last
  void switch_off();  ///< what was found stays

  /// What is in the window now; begins again where it is time to.
  void update(const SweepSubject& subject, Clock::time_point now);
  /// There is nothing to measure until the next update(); what was to be measured is let go.
  void leave();
  /// The person is doing something: no frame is begun until then.
  void rest_until(Clock::time_point time);

  /// Whether something may come of it soon: then has_news() should be asked several times a second.
  bool is_active() const;
  /// Whether results() has something new, or update() would begin a sweep.
  bool has_news(Clock::time_point now) const;
  const AccuracyResults& results();

 private:
  bool is_outdated() const;
  void begin();
  void stop();

  void work(const std::stop_token& quit);
  void run(const SweepRenderer& renderer, const SweepSubject& subject, const std::stop_token& stopped);
  Measurer resting(Measurer measurer, const std::stop_token& stopped);
  void rest(const std::stop_token& stopped);
  /// Changes what results() tells, unless `stopped`: then that is of another sweep.
  void publish(const std::stop_token& stopped, const std::function<void(AccuracyResults&)>& change);

  // Of the window's thread
  bool is_on_ = false;
  std::optional<SweepSubject> latest_, begun_;
  Clock::time_point changed_at_;  ///< when `latest_` came to differ from what it was
  AccuracyResults seen_;
  std::uint64_t seen_version_ = 0;

  // Of the sweep's thread
  std::function<SweepRenderer()> make_renderer_;

  // Of both
  mutable std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<SweepSubject> next_;
  std::stop_source run_;  ///< stops the sweep that begun last
  Clock::time_point rest_until_;
  AccuracyResults found_;
  std::uint64_t version_ = 0;  ///< of `found_`

  std::jthread thread_;
};

}  // namespace crest
